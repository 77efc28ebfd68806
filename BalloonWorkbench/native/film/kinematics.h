// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "element.h"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi" // all that pass Vec4 are inlined
#endif

namespace film {

SIMD_INLINE Vec4 dot(const Vec4 (&a)[3], const Vec4 (&b)[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

SIMD_INLINE void cross(const Vec4 (&a)[3], const Vec4 (&b)[3], Vec4 (&result)[3]) {
    for (int i = 0; i < 3; ++i)
        result[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

// What both kinds of evaluation begin with.
struct Kinematics {
    Vec4 area;
    Vec4 shape[3][2]; // gradients of the area coordinates
    Vec4 f[2][3];
    Vec4 strain[3];      // E11, E22, 2 E12
    Vec4 rotation[3][2]; // of the directors against the triangle, at each corner
};

SIMD_INLINE void compute_kinematics(const FourTriangles& film, Kinematics& k) {
    Vec4 edge[3][2]; // opposite to each corner
    for (int a = 0; a < 3; ++a) {
        for (int i = 0; i < 2; ++i)
            edge[a][i] = film.rest[(a + 2) % 3][i] - film.rest[(a + 1) % 3][i];
    }
    const Vec4 double_area = edge[1][0] * edge[2][1] - edge[1][1] * edge[2][0];
    const Vec4 inverse = 1.0 / double_area;
    k.area = 0.5 * double_area;
    for (int a = 0; a < 3; ++a) {
        k.shape[a][0] = -edge[a][1] * inverse;
        k.shape[a][1] = edge[a][0] * inverse;
    }
    for (int i = 0; i < 3; ++i) {
        const Vec4 first = film.position[1][i] - film.position[0][i];
        const Vec4 second = film.position[2][i] - film.position[0][i];
        for (int c = 0; c < 2; ++c)
            k.f[c][i] = k.shape[1][c] * first + k.shape[2][c] * second;
    }
    k.strain[0] = 0.5 * (dot(k.f[0], k.f[0]) - 1.0);
    k.strain[1] = 0.5 * (dot(k.f[1], k.f[1]) - 1.0);
    k.strain[2] = dot(k.f[0], k.f[1]);
    for (int a = 0; a < 3; ++a) {
        for (int c = 0; c < 2; ++c)
            k.rotation[a][c] = dot(film.director[a], k.f[c]);
    }
}

} // namespace film
