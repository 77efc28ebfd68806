# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts that any task panel is made of: fields tied to properties, pages, file names; no balloon in them."""
