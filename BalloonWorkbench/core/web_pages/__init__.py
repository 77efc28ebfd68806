# SPDX-License-Identifier: LGPL-2.1-or-later
"""Web pages of one file that need no network: of a balloon, and of a study. Printed pages: core/pages."""
