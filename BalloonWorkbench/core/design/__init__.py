# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pattern correction: from the drawing to the panel that inflates to it."""
