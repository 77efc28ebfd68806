// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Film solver: inflates a triangulated film (tension-field membrane, DKT bending, pressure).
//
// Plain C ABI. Arrays are row by row; their sizes stand beside them. All numbers are dimensionless: lengths
// in units of the panel's size, pressure 1. Each function returns a film_status; on failure film_last_error()
// gives the text of the calling thread. A film_solver may be used by one thread at a time.

#ifndef FILM_SOLVER_H
#define FILM_SOLVER_H

#include <stdint.h>

#if defined(_WIN32)
#define FILM_API __declspec(dllexport)
#else
#define FILM_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

enum { FILM_ABI_VERSION = 9 };

typedef enum {
    FILM_OK = 0,
    FILM_BAD_ARGUMENT = 1,
    FILM_NOT_FINITE = 2,
    FILM_CANCELLED = 3,
    FILM_OUT_OF_MEMORY = 4
} film_status;

typedef struct {
    double membrane_stiffness; // E t / (p L)
    double poisson_ratio;
    double flexural_rigidity; // D / (p L^3)
    double pressure;          // 1, or 0 for a film under nodal loads only; with a gradient that at z = 0
    double gradient;          // of the pressure along z, for a closed film
    // with orthotropic set, relative to the modulus along the grain; poisson_ratio is that under tension
    // along it
    double across;         // Young's modulus across the grain
    double shear;          // shear modulus
    double grain_angle;    // from the x axis [rad]
    int32_t orthotropic;   // 0: isotropic
    int32_t tension_field; // 0: a plain shell, which carries compression
    int32_t in_space;      // 0: the seams stay in planes z = constant
} film_material;

// The numbers that steer the iteration, all positive. They are the caller's, so that two solvers can take the
// same steps; the workbench declares them once, with the solver in NumPy, and says there what each one does.
typedef struct {
    double level_tolerance, shift, slack_stiffness, slack_fades, director_shift;
    double first_tension, least_tension, held_back, largest_tension;
    double tension_growth, tension_decay, need_decay; // the growth above 1
    double sufficient, shortest, short_step, middling_step;
    double still_decrement, still_volume, still_seam;
    int32_t still_steps;
    int32_t directions, direction_steps;
} film_constants;

typedef struct {
    double tolerance;  // on the predicted decrease of the energy, relative
    int32_t max_steps; // over all levels
} film_newton;

typedef struct {
    int32_t steps;
    int32_t factorisations;
    int32_t converged;
} film_result;

typedef struct film_solver film_solver;

// Called after each step with the part done, 0 to 1, and on large meshes also during one; returning 0
// cancels.
typedef int32_t (*film_progress)(double fraction, void* user);

FILM_API int32_t film_abi_version(void);
FILM_API const char* film_last_error(void);

// Threads of each solve that begins from now on, in this process; 0: as many as find work. Small meshes take
// one. The result does not depend on it, to the last bit.
FILM_API void film_set_threads(int32_t count);

// rest_positions (vertices, 2); triangle_corners (triangles, 3); fixed (vertices, 5) non-zero where x, y, z
// or one of the two turns of the director is held; loads (vertices, 3) or null; tied (vertices) the
// vertex, itself or one before it, whose position a vertex shares, or null; seam_hinges (hinges, 3):
// neighbours along a seam, with the rigidity E I / (p L^4) of the sealed band there in hinge_rigidities
// (hinges).
FILM_API film_status film_create(int32_t vertices, const double* rest_positions, int32_t triangles,
                                 const int32_t* triangle_corners, const uint8_t* fixed, const double* loads,
                                 const int32_t* tied, int32_t hinges, const int32_t* seam_hinges,
                                 const double* hinge_rigidities, const film_material* material,
                                 const film_constants* constants, film_solver** solver);
FILM_API void film_destroy(film_solver* solver);

// parts[5]: membrane, bending, pressure, load, seam.
FILM_API film_status film_energies(film_solver* solver, const double* positions, const double* directors,
                                   double* parts);

// positions and directors (vertices, 3) hold the start and receive the rest state, also when not converged or
// cancelled (then the last accepted state). levels: the membrane stiffnesses to go through, the film's own
// last.
FILM_API film_status film_solve(film_solver* solver, double* positions, double* directors,
                                int32_t level_count, const double* levels, const film_newton* settings,
                                film_progress progress, void* user, film_result* result);

// How the film gives way to loads (vertices, 5, fields) on x, y, z of each vertex and the two turns of its
// director, in the first order: moves (vertices, 3, fields) receives the changes of the positions. exact
// receives 0 where the exact Hessian is not positive definite, and that of the iteration took its place.
FILM_API film_status film_tangent_solve(film_solver* solver, const double* positions, const double* directors,
                                        int32_t fields, const double* loads, double* moves, int32_t* exact);

#ifdef __cplusplus
}
#endif

#endif
