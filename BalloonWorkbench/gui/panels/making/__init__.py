# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panels for making a balloon: files for machines, prints, film, the assembly sheet."""
