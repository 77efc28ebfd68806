# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies: many balloons from one table or grid, into one folder and one table; not how a balloon is made.

1. what is asked for: rows of values, lazily        read_study.py, axes.py, columns.py
2. which balloons these are, each once              plan.py, key.py
3. working them out, wherever                       runners, run.py
4. one folder a balloon, all or nothing             folder.py
5. one table                                        results.py, table.py
6. one web page                                     page.py

What works out a job is a module that `Job.task` names: `make(request)` gives the contents of its files by
name, `report.json` among them. That of a balloon is cli/studies/row.py.
"""
