# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the drawing of an Outline object comes from: a file, a painting, a sketch; the tracing is core's."""
