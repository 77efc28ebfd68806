// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Dense>

namespace film {

// Energy density, second Piola-Kirchhoff stress and tangent in units of E t.
struct MembraneResponse {
    double energy;
    Eigen::Vector3d stress;
    Eigen::Matrix3d tangent;
};

// The tension field (Pipkin 1986, Steigmann 1990) at Green strain (E11, E22, 2 E12): slack, wrinkled or taut.
MembraneResponse tension_field(const Eigen::Vector3d& strain, double poisson_ratio);

// The energy density alone.
double tension_field_energy(const Eigen::Vector3d& strain, double poisson_ratio);

} // namespace film
