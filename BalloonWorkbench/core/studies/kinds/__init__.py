# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies with a question: what do errors cost, which balloon is best. Their rows are as of any study."""
