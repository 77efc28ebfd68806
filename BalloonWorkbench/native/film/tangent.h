// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "shell.h"

namespace film {

// How a film gives way to loads (vertices, 5, fields) on its unknowns, in the first order: the moves
// (vertices, 3, fields) of its positions. Returns whether the exact Hessian is positive definite; else
// Newton's takes its place, with the least tried tension that makes it so. The same as in the NumPy solver.
bool tangent_solve(Shell shell, const State& state, const film_constants& constants, int fields,
                   const double* loads, double* moves);

} // namespace film
