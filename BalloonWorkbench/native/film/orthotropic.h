// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "membrane.h"

namespace film {

// Elasticity of a film with a grain, relative to the modulus along it; angle from the x axis of the panel.
struct Grain {
    double across, shear, poisson, angle;

    // Plane stress in the grain's axes.
    Eigen::Matrix3d stiffness() const;
    // From strains (E11, E22, 2 E12) in the panel's axes to those in the grain's.
    Eigen::Matrix3d rotation() const;
};

// How the direction of tension is looked for: so many are tried, the best is improved by Newton's method.
struct DirectionSearch {
    int directions, steps;
};

// The tension field of an orthotropic film, relaxed by duality as in the NumPy solver.
MembraneResponse orthotropic_tension_field(const Eigen::Vector3d& strain, const Grain& grain,
                                           const DirectionSearch& search);

} // namespace film
