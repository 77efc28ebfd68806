// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Dense>

namespace film {

using Matrix32 = Eigen::Matrix<double, 3, 2>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

// Gradients of the area coordinates (rows) and the area of a flat triangle with these corners (rows).
Matrix32 area_coordinate_gradients(const Matrix32& corners, double& area);

// Stiffness per flexural rigidity in (beta_x, beta_y) of the corners with w = 0 (Batoz, Bathe and Ho 1980).
Matrix6 rotation_stiffness(const Matrix32& corners, double poisson_ratio);

} // namespace film
