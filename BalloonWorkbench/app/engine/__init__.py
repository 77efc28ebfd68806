# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the objects of a document ask of core: solving, advice, numbers, files; no properties of their own."""
