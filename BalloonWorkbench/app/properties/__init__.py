# SPDX-License-Identifier: LGPL-2.1-or-later
"""What stands in an object's properties: values, units, materials, preferences; no geometry."""
