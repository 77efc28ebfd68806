# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is read from an inflated balloon: states and loads of film and seams; nothing is solved here."""
