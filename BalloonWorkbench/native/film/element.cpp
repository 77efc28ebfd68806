// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Membrane and bending depend on the positions through F = dx/dX alone, with columns f[0] and f[1]: their
// Hessian is formed in these six numbers and the directors and then spread over the corners.
#include "element.h"

#include "dkt.h"
#include "kinematics.h"

namespace film {
namespace {

SIMD_INLINE Vec4 sum_of_heights(const FourTriangles& film) {
    return film.position[0][2] + film.position[1][2] + film.position[2][2];
}

SIMD_INLINE void energies_body(const FourTriangles& film, const FilmLaw& law, double nu,
                               FourEnergies& energies) {
    Kinematics k;
    compute_kinematics(film, k);
    FourResponses response;
    law.respond<false>(k.strain, response);
    energies.membrane = k.area * response.energy;

    Curvatures curvatures;
    compute_curvatures(k, curvatures);
    Vec4 sum{};
    for (int m = 0; m < 3; ++m) { // the middles of the sides integrate a quadratic exactly
        Vec4 kappa[3] = {};
        for (int i = 0; i < 3; ++i) {
            for (int a = 0; a < 3; ++a)
                kappa[i] = kappa[i] + curvatures.from[m][i][a][0] * k.rotation[a][0]
                           + curvatures.from[m][i][a][1] * k.rotation[a][1];
        }
        sum = sum + kappa[0] * kappa[0] + kappa[1] * kappa[1] + 2.0 * nu * kappa[0] * kappa[1]
              + 0.5 * (1.0 - nu) * kappa[2] * kappa[2];
    }
    energies.bending = k.area * sum * (1.0 / 6.0);

    Vec4 normal[3];
    cross(film.position[1], film.position[2], normal);
    energies.volume = dot(film.position[0], normal) * (1.0 / 6.0);
    energies.moment = 0.25 * energies.volume * sum_of_heights(film);
}

// The Hessian in F and the turns of the directors, and what the gradient is made of.
struct Tangent {
    Vec4 pull[2][3];        // by f
    Vec4 turn[3][2];        // by the turns
    Vec4 stretch[3][3][3];  // by f[0] twice, f[1] and f[0], f[1] twice
    Vec4 mixed[3][2][2][3]; // corner, turn; by f
    Vec4 turns[3][2][3][2]; // by the turns of two corners
    Vec4 moment[3][2];      // by the rotations at each corner
};

SIMD_INLINE void add_membrane(const Kinematics& k, const FilmLaw& law, const FilmScales& scales,
                              Tangent& tangent) {
    FourResponses response;
    law.respond<true>(k.strain, response);
    const Vec4 scale = k.area * scales.membrane_stiffness;
    const Vec4(&f)[2][3] = k.f;
    Vec4 s[3], c[3][3];
    for (int i = 0; i < 3; ++i) {
        s[i] = scale * response.stress[i];
        for (int j = 0; j < 3; ++j)
            c[i][j] = scale * (response.tangent[i][j] + scales.slack_stiffness * law.taut_stiffness(i, j));
    }
    for (int i = 0; i < 3; ++i) {
        tangent.pull[0][i] = s[0] * f[0][i] + s[2] * f[1][i];
        tangent.pull[1][i] = s[1] * f[1][i] + s[2] * f[0][i];
        // stresses that come with a change of f[0][i] and of f[1][i]
        Vec4 by[2][3];
        for (int j = 0; j < 3; ++j) {
            by[0][j] = c[j][0] * f[0][i] + c[j][2] * f[1][i];
            by[1][j] = c[j][1] * f[1][i] + c[j][2] * f[0][i];
        }
        for (int j = 0; j < 3; ++j) {
            tangent.stretch[0][i][j] = by[0][0] * f[0][j] + by[0][2] * f[1][j];
            tangent.stretch[1][i][j] = by[1][0] * f[0][j] + by[1][2] * f[1][j];
            tangent.stretch[2][i][j] = by[1][1] * f[1][j] + by[1][2] * f[0][j];
        }
        tangent.stretch[0][i][i] = tangent.stretch[0][i][i] + s[0];
        tangent.stretch[1][i][i] = tangent.stretch[1][i][i] + s[2];
        tangent.stretch[2][i][i] = tangent.stretch[2][i][i] + s[1];
    }
}

// The bending stiffness of one turn of a director, whose rotations have these slopes and rows of stiffness,
// with the turns of all three.
SIMD_INLINE void set_turns(const FourTriangles& film, const Kinematics& k, const Vec4 (&first)[6],
                           const Vec4 (&second)[6], const Vec4 (&slope)[2], Vec4 (&turns)[3][2]) {
    Vec4 row[6]; // change of all moments with this turn
    for (int i = 0; i < 6; ++i)
        row[i] = slope[0] * first[i] + slope[1] * second[i];
    for (int b = 0; b < 3; ++b) {
        for (int u = 0; u < 2; ++u)
            turns[b][u] =
                row[2 * b] * dot(film.frame[b][u], k.f[0]) + row[2 * b + 1] * dot(film.frame[b][u], k.f[1]);
    }
}

// Gauss-Newton: without the second derivatives of the rotations.
SIMD_INLINE void add_bending(const FourTriangles& film, const Kinematics& k, const FilmScales& scales,
                             Tangent& tangent) {
    Vec4 stiffness[6][6];
    bending_stiffness(k, scales, stiffness);
    for (int a = 0; a < 3; ++a) {
        Vec4 slope[2][2]; // of the rotations by the turns
        for (int t = 0; t < 2; ++t) {
            slope[t][0] = dot(film.frame[a][t], k.f[0]);
            slope[t][1] = dot(film.frame[a][t], k.f[1]);
        }
        Vec4(&moment)[2] = tangent.moment[a];
        for (int c = 0; c < 2; ++c) {
            moment[c] = Vec4{};
            for (int b = 0; b < 3; ++b)
                moment[c] = moment[c] + stiffness[2 * a + c][2 * b] * k.rotation[b][0]
                            + stiffness[2 * a + c][2 * b + 1] * k.rotation[b][1];
            Vec4 by[2][3] = {}; // change of this moment with f
            for (int i = 0; i < 3; ++i) {
                tangent.pull[c][i] = tangent.pull[c][i] + moment[c] * film.director[a][i];
                for (int b = 0; b < 3; ++b) {
                    by[0][i] = by[0][i] + stiffness[2 * a + c][2 * b] * film.director[b][i];
                    by[1][i] = by[1][i] + stiffness[2 * a + c][2 * b + 1] * film.director[b][i];
                }
            }
            for (int i = 0; i < 3; ++i) {
                for (int j = 0; j < 3; ++j) {
                    tangent.stretch[c][i][j] = tangent.stretch[c][i][j] + film.director[a][i] * by[0][j];
                    if (c == 1)
                        tangent.stretch[2][i][j] = tangent.stretch[2][i][j] + film.director[a][i] * by[1][j];
                }
            }
            for (int t = 0; t < 2; ++t) {
                for (int i = 0; i < 3; ++i) {
                    for (int e = 0; e < 2; ++e) {
                        const Vec4 before = c == 0 ? Vec4{} : tangent.mixed[a][t][e][i];
                        tangent.mixed[a][t][e][i] = before + slope[t][c] * by[e][i];
                    }
                }
            }
        }
        for (int t = 0; t < 2; ++t) {
            tangent.turn[a][t] = moment[0] * slope[t][0] + moment[1] * slope[t][1];
            set_turns(film, k, stiffness[2 * a], stiffness[2 * a + 1], slope[t], tangent.turns[a][t]);
        }
    }
}

// What Gauss-Newton leaves out. A rotation is bilinear in f and the director; a director that turns by an
// angle t sinks by t^2 / 2.
SIMD_INLINE void add_second_rotations(const FourTriangles& film, const Kinematics& k, Tangent& tangent) {
    for (int a = 0; a < 3; ++a) {
        const Vec4(&moment)[2] = tangent.moment[a];
        const Vec4 sunk = moment[0] * k.rotation[a][0] + moment[1] * k.rotation[a][1];
        for (int t = 0; t < 2; ++t) {
            tangent.turns[a][t][a][t] = tangent.turns[a][t][a][t] - sunk;
            for (int c = 0; c < 2; ++c) {
                for (int i = 0; i < 3; ++i)
                    tangent.mixed[a][t][c][i] = tangent.mixed[a][t][c][i] + moment[c] * film.frame[a][t][i];
            }
        }
    }
}

// The pressure of a triangle changes with its heights.
SIMD_INLINE void add_gradient(const FourTriangles& film, double gradient, FourElements& elements) {
    if (gradient == 0.0)
        return;
    Vec4 change[3][3]; // of the volume with each corner, times a quarter of the gradient
    for (int a = 0; a < 3; ++a) {
        cross(film.position[(a + 1) % 3], film.position[(a + 2) % 3], change[a]);
        for (int i = 0; i < 3; ++i)
            change[a][i] = change[a][i] * (0.25 * gradient / 6.0);
    }
    const Vec4 own = dot(film.position[0], change[0]);
    for (int a = 0; a < 3; ++a)
        elements.force[a][2] = elements.force[a][2] - own;
    for (int pair = 0; pair < 6; ++pair) {
        const int a = FourElements::kPairs[pair][0], b = FourElements::kPairs[pair][1];
        Vec4(&block)[5][5] = elements.stiffness[pair];
        for (int i = 0; i < 3; ++i) {
            block[i][2] = block[i][2] - change[a][i];
            block[2][i] = block[2][i] - change[b][i];
        }
    }
}

SIMD_INLINE void derivatives_body(const FourTriangles& film, const FilmLaw& law, const FilmScales& scales,
                                  FourElements& elements) {
    Kinematics k;
    compute_kinematics(film, k);
    Tangent tangent;
    add_membrane(k, law, scales, tangent);
    add_bending(film, k, scales, tangent);
    if (scales.exact)
        add_second_rotations(film, k, tangent);
    for (int i = 0; i < 3; ++i) {
        tangent.stretch[0][i][i] = tangent.stretch[0][i][i] + scales.tension * k.area;
        tangent.stretch[2][i][i] = tangent.stretch[2][i][i] + scales.tension * k.area;
    }

    // the pressure's energy is - p times the volume
    const Vec4 nodal = (scales.pressure + 0.25 * scales.gradient * sum_of_heights(film)) / 6.0;
    for (int a = 0; a < 3; ++a) {
        const Vec4(&g)[2] = k.shape[a];
        Vec4 normal[3];
        cross(film.position[(a + 1) % 3], film.position[(a + 2) % 3], normal);
        for (int i = 0; i < 3; ++i)
            elements.force[a][i] = g[0] * tangent.pull[0][i] + g[1] * tangent.pull[1][i] - nodal * normal[i];
        for (int t = 0; t < 2; ++t)
            elements.force[a][3 + t] = tangent.turn[a][t];
    }
    for (int pair = 0; pair < 6; ++pair) {
        const int a = FourElements::kPairs[pair][0], b = FourElements::kPairs[pair][1];
        const Vec4(&g)[2] = k.shape[a];
        const Vec4(&h)[2] = k.shape[b];
        Vec4(&block)[5][5] = elements.stiffness[pair];
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j)
                block[i][j] = g[0] * (h[0] * tangent.stretch[0][i][j] + h[1] * tangent.stretch[1][j][i])
                              + g[1] * (h[0] * tangent.stretch[1][i][j] + h[1] * tangent.stretch[2][i][j]);
            for (int t = 0; t < 2; ++t) {
                block[i][3 + t] = g[0] * tangent.mixed[b][t][0][i] + g[1] * tangent.mixed[b][t][1][i];
                block[3 + t][i] = h[0] * tangent.mixed[a][t][0][i] + h[1] * tangent.mixed[a][t][1][i];
            }
        }
        for (int t = 0; t < 2; ++t) {
            for (int u = 0; u < 2; ++u)
                block[3 + t][3 + u] = tangent.turns[a][t][b][u];
        }
        if (a != b) { // the pressure turns with the film
            const Vec4(&third)[3] = film.position[3 - a - b];
            const Vec4 sign = a - b == 2 ? nodal : -nodal;
            for (int i = 0; i < 3; ++i) {
                const int j = (i + 1) % 3, l = (i + 2) % 3;
                block[j][i] = block[j][i] + sign * third[l];
                block[i][j] = block[i][j] - sign * third[l];
            }
        }
    }
    add_gradient(film, scales.gradient, elements);
}

// The same functions compiled for one instruction set.
// NOLINTBEGIN(bugprone-macro-parentheses): an attribute cannot stand in parentheses
#define FILM_ELEMENT_KERNELS(NAME, TARGET)                                                                   \
    TARGET void energies_##NAME(const FourTriangles& film, const FilmLaw& law, double nu,                    \
                                FourEnergies& energies) {                                                    \
        energies_body(film, law, nu, energies);                                                              \
    }                                                                                                        \
    TARGET void derivatives_##NAME(const FourTriangles& film, const FilmLaw& law, const FilmScales& scales,  \
                                   FourElements& elements) {                                                 \
        derivatives_body(film, law, scales, elements);                                                       \
    }                                                                                                        \
    constexpr FilmKernels NAME{energies_##NAME, derivatives_##NAME};
// NOLINTEND(bugprone-macro-parentheses)

FILM_ELEMENT_KERNELS(portable, )
#ifdef SIMD_HAS_AVX2
FILM_ELEMENT_KERNELS(avx2, SIMD_AVX2)
#endif

} // namespace

const FilmKernels& film_kernels() {
#ifdef SIMD_HAS_AVX2
    if (has_avx2())
        return avx2;
#endif
    return portable;
}

} // namespace film
