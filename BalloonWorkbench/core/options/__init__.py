# SPDX-License-Identifier: LGPL-2.1-or-later
"""All that a user may choose, declared once; not what it does, and no arrays: FreeCAD's start reads it.

An option is a field of a dataclass. Command line, document property, panel field, Python API, preference,
report and documentation follow from its declaration.
"""
