// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Sparse>

namespace film {

using SymmetricMatrix = Eigen::SparseMatrix<double>; // lower triangle only

} // namespace film
