# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a maker's errors do to a balloon: spreads, samples, what each sample makes, and all of them together.

Not here: rows, tables and folders of studies (core/studies).
"""
