# SPDX-License-Identifier: LGPL-2.1-or-later
"""The assembly sheet: one page that tells how a balloon is made."""
