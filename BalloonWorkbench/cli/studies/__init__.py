# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command study, and the processes that work out its balloons; what a study is, core knows."""
