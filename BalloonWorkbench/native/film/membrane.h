// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Dense>

#include "simd/vec4.h"

namespace film {

using namespace simd;

// Energy density, second Piola-Kirchhoff stress and tangent in units of E t, at Green strain
// (E11, E22, 2 E12).
struct MembraneResponse {
    double energy;
    Eigen::Vector3d stress;
    Eigen::Matrix3d tangent;
};

// The same of four triangles.
struct FourResponses {
    Vec4 energy;
    Vec4 stress[3];
    Vec4 tangent[3][3];
};

// The tension field (Pipkin 1986, Steigmann 1990): slack, wrinkled or taut. With Whole, stress and tangent
// too.
template <bool Whole>
SIMD_INLINE void tension_field(const Vec4 (&strain)[3], double nu, FourResponses& response) {
    const Vec4 zero{};
    const Vec4 mean = 0.5 * (strain[0] + strain[1]), half = 0.5 * (strain[0] - strain[1]);
    Vec4 radius = half * half + 0.25 * strain[2] * strain[2];
    square_root(radius);
    const Vec4 major = mean + radius, taut = mean - radius + nu * major;
    const double scale = 1.0 / (1.0 - nu * nu), shear = 0.5 / (1.0 + nu);
    const Vec4 taut_stress[3] = {scale * (strain[0] + nu * strain[1]), scale * (strain[1] + nu * strain[0]),
                                 shear * strain[2]};
    const Vec4 taut_energy =
        0.5 * (taut_stress[0] * strain[0] + taut_stress[1] * strain[1] + taut_stress[2] * strain[2]);
    Vec4 pull; // of wrinkled film along its wrinkles; 0 of slack film
    select(major, major, zero, pull);
    select(taut, taut_energy, 0.5 * pull * pull, response.energy);
    if (!Whole)
        return;

    // cosine and sine of twice the angle of the major strain; there is none where the film is taut alike
    Vec4 inverse, wrinkled;
    select(radius, 1.0 / radius, zero, inverse);
    select(major, zero + 1.0, zero, wrinkled);
    const Vec4 c = half * inverse, s = 0.5 * strain[2] * inverse;
    const Vec4 along[3] = {0.5 * (1.0 + c), 0.5 * (1.0 - c), 0.5 * s}; // E1 = along . strain
    const Vec4 across[3] = {-0.5 * s, 0.5 * s, 0.5 * c};               // shear that turns the wrinkles
    const Vec4 turning = pull * inverse;
    const double taut_tangent[3][3] = {{scale, scale * nu, 0.0}, {scale * nu, scale, 0.0}, {0.0, 0.0, shear}};
    for (int i = 0; i < 3; ++i) {
        select(taut, taut_stress[i], pull * along[i], response.stress[i]);
        for (int j = 0; j <= i; ++j) {
            select(taut, zero + taut_tangent[i][j],
                   wrinkled * along[i] * along[j] + turning * across[i] * across[j], response.tangent[i][j]);
            response.tangent[j][i] = response.tangent[i][j];
        }
    }
}

} // namespace film
