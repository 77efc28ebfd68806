# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process beside a study: a job a line on its input, what became of it a line on its output.

python -m BalloonWorkbench.cli.studies.worker FOLDER; started by core/studies/runners/worker.py.
"""

from __future__ import annotations

import importlib
import json
import os
import signal
import sys
from typing import Any, TextIO

from BalloonWorkbench.cli.home import home
from BalloonWorkbench.core.errors import (
    BalloonError,
    ExportError,
    FetchError,
    MissingPackageError,
    ProgramFault,
)
from BalloonWorkbench.core.faults import report_fault
from BalloonWorkbench.core.studies.folder import StudyFolder
from BalloonWorkbench.core.studies.key import program

#: Failures that another machine, or the same one tomorrow, need not have.
_PASSING = (MissingPackageError, FetchError, ExportError, ProgramFault)


def main(place: str) -> int:
    """Work out jobs until there are no more."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the study ends us
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)  # what packages print is no answer
    folder = StudyFolder(place)
    _answer(answers, {"program": program()})
    with home():
        for line in sys.stdin:
            job = json.loads(line)
            _answer(answers, _worked(job["key"], job["task"], job["request"], folder))
    return 0


def _answer(answers: TextIO, answer: dict[str, Any]) -> None:
    answers.write(json.dumps(answer) + "\n")
    answers.flush()


def _worked(key: str, task: str, request: dict[str, Any], folder: StudyFolder) -> dict[str, Any]:
    """What became of a job; its files, or why it cannot be made, are in the folder then."""
    sentence, kept = "", True
    try:
        contents = importlib.import_module(task).make(request)
    except BalloonError as error:
        sentence, kept = str(error), not isinstance(error, _PASSING)
    except Exception as error:  # noqa: BLE001 - a row of the study is told by a sentence
        sentence, kept = str(report_fault(error, "making a balloon of a study")), False
    try:
        if not sentence:
            folder.keep(key, contents)
        elif kept:
            folder.keep_failure(key, sentence)
    except ExportError as error:
        return {"sentence": str(error), "kept": False, "ends": True}
    return {"sentence": " ".join(sentence.split()), "kept": kept, "ends": False}


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
