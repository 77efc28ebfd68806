# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machines of the user's own: what a form shows of one, and how their files are kept.

What a machine is, and how its file is read: core/machines/machine.py.
"""
