# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edits of an outline by hand: nodes on its loops, and how they were changed; nothing is traced here."""
