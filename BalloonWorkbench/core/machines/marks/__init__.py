# SPDX-License-Identifier: LGPL-2.1-or-later
"""Registration marks: by which a machine finds a print again, as data, and placed round a sheet."""
