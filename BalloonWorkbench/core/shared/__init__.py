# SPDX-License-Identifier: LGPL-2.1-or-later
"""What shows finished jobs of all kinds to others. How they are written: scenes, web_pages."""
