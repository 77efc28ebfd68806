# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files and folders: written all or none, data files read. What is in them is decided elsewhere."""
