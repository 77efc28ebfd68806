# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents as a whole: what is in them, where it lies, older ones; no single kind of object."""
