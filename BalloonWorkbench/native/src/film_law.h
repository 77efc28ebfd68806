// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "film_solver.h"
#include "orthotropic.h"

namespace film {

// The membrane law that a material asks for: with or without a grain, as a tension field or a plain shell.
class FilmLaw {
public:
    explicit FilmLaw(const film_material& material);

    MembraneResponse response(const Eigen::Vector3d& strain) const;
    double energy(const Eigen::Vector3d& strain) const;

private:
    double poisson_;
    bool orthotropic_, tension_field_;
    Grain grain_;
    Eigen::Matrix3d stiffness_; // of the plain shell
};

} // namespace film
