# SPDX-License-Identifier: LGPL-2.1-or-later
"""The compiled solver: which library is loaded and how it is called; its sources are in native/."""
