# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rules about what inflates badly: places, findings, repairs. They read a shape and change none."""
