# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the jobs of a study are worked out: processes here, Dask, job arrays; not what a job is."""
