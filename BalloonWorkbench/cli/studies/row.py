# SPDX-License-Identifier: LGPL-2.1-or-later
"""A balloon of a study: what `design` or `inflate` makes with the same options."""

from __future__ import annotations

import argparse
import json
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from BalloonWorkbench.cli import command_line, many_panels
from BalloonWorkbench.cli.options import parser
from BalloonWorkbench.cli.settings import balloon_of, settings_of
from BalloonWorkbench.core.job import report_bytes
from BalloonWorkbench.core.shared.sharing import small_png
from BalloonWorkbench.core.studies.folder import REPORT as NAME
from BalloonWorkbench.core.studies.job import FILES, PICTURE, PICTURES
from BalloonWorkbench.core.studies.results import without_times
from BalloonWorkbench.core.targets.form import has_many_panels


def make(request: Mapping[str, Any]) -> dict[str, bytes]:
    """The files of a balloon by name. Raises BalloonError.

    request  arguments: of the command line, but for --out; keep: one of KEPT (core/studies/job.py)
    """
    with tempfile.TemporaryDirectory() as folder:
        options = parser().parse_args([*request["arguments"], f"--out={folder}"])
        if request["keep"] == FILES:
            command_line.run_quietly(options)
            contents = {path.name: path.read_bytes() for path in sorted(Path(folder).iterdir())}
        else:
            contents = _report(options, pictured=request["keep"] == PICTURES)
    if NAME in contents:
        contents[NAME] = report_bytes(without_times(json.loads(contents[NAME])))
    return contents


def _report(options: argparse.Namespace, *, pictured: bool) -> dict[str, bytes]:
    """The report alone, or with a small picture."""
    settings = settings_of(options)
    if has_many_panels(options.input, settings.body, settings.side_band):
        many_panels.check(options)
    balloon = balloon_of(options, settings, (options.width, options.height))
    contents = {NAME: report_bytes(balloon.report)}
    return contents | ({PICTURE: small_png(balloon)} if pictured else {})
