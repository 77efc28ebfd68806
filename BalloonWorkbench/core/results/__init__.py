# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a simulation gives: state and load of the film, maps, files. Nothing is solved here."""
