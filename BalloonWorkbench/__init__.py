# SPDX-License-Identifier: LGPL-2.1-or-later
"""Film Balloon workbench: designs balloons from film that does not stretch."""

__version__ = "0.1.0"
