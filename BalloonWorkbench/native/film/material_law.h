// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "film_solver.h"
#include "orthotropic.h"

namespace film {

// The membrane law that a material asks for: with or without a grain, as a tension field or a plain shell.
class FilmLaw {
public:
    FilmLaw(const film_material& material, const film_constants& constants);

    // With Whole, stress and tangent, else the energy density alone.
    template <bool Whole>
    SIMD_INLINE void respond(const Vec4 (&strain)[3], FourResponses& response) const {
        if (tension_field_ && !orthotropic_)
            tension_field<Whole>(strain, poisson_, response);
        else
            lane_by_lane(strain, response);
    }

    // Of taut film, from E11, E22, 2 E12.
    double taut_stiffness(int i, int j) const { return stiffness_(i, j); }

private:
    MembraneResponse response(const Eigen::Vector3d& strain) const;
    void lane_by_lane(const Vec4 (&strain)[3], FourResponses& response) const;

    double poisson_;
    bool orthotropic_, tension_field_;
    Grain grain_;
    DirectionSearch search_;
    Eigen::Matrix3d stiffness_; // of taut film
};

} // namespace film
