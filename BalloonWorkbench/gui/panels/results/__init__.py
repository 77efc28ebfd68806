# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panels that show a finished balloon: advice, colours, its inflation, files; they design nothing."""
