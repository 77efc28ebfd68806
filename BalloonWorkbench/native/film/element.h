// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "material_law.h"

namespace film {

// Four triangles of film at a time, their corners in counter-clockwise order.
struct FourTriangles {
    Vec4 rest[3][2];
    Vec4 position[3][3];
    Vec4 director[3][3];
    Vec4 frame[3][2][3]; // two unit vectors across each director; for derivatives only
};

struct FourEnergies {
    Vec4 membrane; // per membrane stiffness
    Vec4 bending;  // per flexural rigidity
    Vec4 volume;   // between the film and the plane z = 0
    Vec4 moment;   // the integral of z over the tetrahedra with the origin
};

// Gradient and Hessian in x, y, z and the two turns of the director at each corner.
struct FourElements {
    // Pairs of corners, the rows' and the columns', of the blocks of the lower triangle.
    static constexpr int kPairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 0}, {2, 0}, {2, 1}};

    Vec4 force[3][5];
    Vec4 stiffness[6][5][5];
};

struct FilmScales {
    double membrane_stiffness, flexural_rigidity, poisson_ratio, pressure;
    double gradient = 0.0;        // of the pressure along z
    double tension = 0.0;         // added to the film's own in the Hessian
    double slack_stiffness = 0.0; // so much of taut film's, added in the Hessian
    bool exact = false;           // with the second derivatives of the rotations in the Hessian
};

struct FilmKernels {
    void (*energies)(const FourTriangles& film, const FilmLaw& law, double poisson_ratio,
                     FourEnergies& energies);
    void (*derivatives)(const FourTriangles& film, const FilmLaw& law, const FilmScales& scales,
                        FourElements& elements);
};

// The fastest that this processor can run.
const FilmKernels& film_kernels();

} // namespace film
