// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "kinematics.h"

namespace film {

// Curvatures (b_x,x; b_y,y; b_x,y + b_y,x) in the middle of each side from the rotations at the corners: the
// discrete Kirchhoff triangle of Batoz, Bathe and Ho (1980) with w = 0. There the rotation in the middle of a
// side is (3 n n^T - 1) / 4 times the sum of those at its ends, n being the normal of the side.
struct Curvatures {
    Vec4 from[3][3][3][2]; // side opposite to a corner, curvature, corner, rotation
};

SIMD_INLINE void compute_curvatures(const Kinematics& k, Curvatures& curvatures) {
    Vec4 normal[3][3]; // 1.5 n n^T of each side: xx, yy, xy
    for (int a = 0; a < 3; ++a) {
        const Vec4 x = k.shape[a][0], y = k.shape[a][1], scale = 1.5 / (x * x + y * y);
        normal[a][0] = scale * x * x;
        normal[a][1] = scale * y * y;
        normal[a][2] = scale * x * y;
    }
    for (int m = 0; m < 3; ++m) {
        const Vec4(&g)[2] = k.shape[m];
        for (int corner = 0; corner < 3; ++corner) {
            const int other = 3 - m - corner; // for a corner at the side: its other end
            Vec4 through[3];                  // what the middles of the sides pass on, as above
            for (int i = 0; i < 3; ++i)
                through[i] = corner == m ? normal[(m + 1) % 3][i] + normal[(m + 2) % 3][i]
                                         : normal[other][i] - normal[m][i];
            Vec4 own[2] = {};
            if (corner == m) {
                through[0] = through[0] - 2.0;
                through[1] = through[1] - 2.0;
            } else {
                own[0] = k.shape[corner][0];
                own[1] = k.shape[corner][1];
            }
            curvatures.from[m][0][corner][0] = through[0] * g[0] + own[0];
            curvatures.from[m][0][corner][1] = through[2] * g[0];
            curvatures.from[m][1][corner][0] = through[2] * g[1];
            curvatures.from[m][1][corner][1] = through[1] * g[1] + own[1];
            curvatures.from[m][2][corner][0] = through[0] * g[1] + through[2] * g[0] + own[1];
            curvatures.from[m][2][corner][1] = through[2] * g[1] + through[1] * g[0] + own[0];
        }
    }
}

// Bending stiffness in the rotations at the corners.
SIMD_INLINE void bending_stiffness(const Kinematics& k, const FilmScales& scales, Vec4 (&stiffness)[6][6]) {
    Curvatures curvatures;
    compute_curvatures(k, curvatures);
    const Vec4 scale = k.area * (scales.flexural_rigidity / 3.0);
    const double nu = scales.poisson_ratio;
    for (int i = 0; i < 6; ++i) {
        Vec4 moment[3][3]; // at the middle of each side
        for (int m = 0; m < 3; ++m) {
            const Vec4 x = curvatures.from[m][0][i / 2][i % 2], y = curvatures.from[m][1][i / 2][i % 2];
            moment[m][0] = scale * (x + nu * y);
            moment[m][1] = scale * (y + nu * x);
            moment[m][2] = scale * (0.5 * (1.0 - nu)) * curvatures.from[m][2][i / 2][i % 2];
        }
        for (int j = 0; j <= i; ++j) {
            Vec4 sum{};
            for (int m = 0; m < 3; ++m) {
                for (int c = 0; c < 3; ++c)
                    sum = sum + moment[m][c] * curvatures.from[m][c][j / 2][j % 2];
            }
            stiffness[i][j] = stiffness[j][i] = sum;
        }
    }
}

} // namespace film
