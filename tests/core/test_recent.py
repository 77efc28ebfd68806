# SPDX-License-Identifier: LGPL-2.1-or-later
"""The last things found are kept, the oldest go."""

from __future__ import annotations

from BalloonWorkbench.core.recent import Recent


def test_the_oldest_go() -> None:
    found: Recent[str, int] = Recent(2)
    for number, word in enumerate("abc"):
        found[word] = number
    assert dict(found) == {"b": 1, "c": 2}
    found["b"] = 3  # what is there stays where it is
    assert dict(found) == {"b": 3, "c": 2}
