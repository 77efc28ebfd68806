# SPDX-License-Identifier: LGPL-2.1-or-later
"""What cannot be laid flat ends with a sentence."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.sparse import csc_matrix

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.flattening.factor import factored


def test_a_solution() -> None:
    matrix = csc_matrix([[2.0, -1.0], [-1.0, 2.0]])
    assert factored(matrix).solve(np.array([0.0, 3.0])) == pytest.approx([1.0, 2.0])


def test_a_singular_system_is_told() -> None:
    with pytest.raises(InputError, match="cannot be laid flat"):
        factored(csc_matrix((2, 2)))
