/* SPDX-License-Identifier: LGPL-2.1-or-later
 *
 * The solver from plain C: inflates a small disc and tries the return codes. Exits 0 when all is well.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "film_solver.h"

/* CONSTANTS, from the compiler's command line: those of core/solver/c_interface.py in their order. */
static const film_constants constants = {CONSTANTS};

enum { RINGS = 6, VERTICES = 1 + 3 * RINGS * (RINGS + 1), TRIANGLES = 6 * RINGS * RINGS, RIM = 6 * RINGS };

static double rest[VERTICES][2], positions[VERTICES][3], directors[VERTICES][3];
static int32_t triangles[TRIANGLES][3], hinges[RIM][3];
static double rigidities[RIM];
static uint8_t fixed[VERTICES][5];
static int failures = 0, calls = 0;

static void check(int passed, const char* what) {
    if (!passed) {
        fprintf(stderr, "failed: %s (last error: %s)\n", what, film_last_error());
        ++failures;
    }
}

/* The number of a vertex: 6 r of them on ring r, counted round and round. */
static int32_t vertex(int ring, int place) {
    return ring == 0 ? 0 : (int32_t)(1 + 3 * ring * (ring - 1) + place % (6 * ring));
}

/* A disc of diameter 1 from concentric rings, lifted to a paraboloid. */
static void make_disc(void) {
    const double pi = acos(-1.0);
    int count = 0;
    for (int ring = 0; ring <= RINGS; ++ring) {
        for (int place = 0; place < (ring ? 6 * ring : 1); ++place) {
            const int32_t v = vertex(ring, place);
            const double radius = 0.5 * ring / RINGS, turn = ring ? 2.0 * pi * place / (6.0 * ring) : 0.0;
            const double r = 2.0 * radius, length = sqrt(1.0 + 0.64 * r * r);
            rest[v][0] = positions[v][0] = radius * cos(turn);
            rest[v][1] = positions[v][1] = radius * sin(turn);
            positions[v][2] = 0.2 * (1.0 - r * r);
            directors[v][0] = 0.8 * r * cos(turn) / length;
            directors[v][1] = 0.8 * r * sin(turn) / length;
            directors[v][2] = 1.0 / length;
            fixed[v][2] = ring == RINGS;
        }
    }
    for (int ring = 1; ring <= RINGS; ++ring) {
        for (int sixth = 0; sixth < 6; ++sixth) {
            for (int k = 0; k < ring; ++k) {
                const int outer = sixth * ring + k, inner = sixth * (ring - 1) + k;
                triangles[count][0] = vertex(ring - 1, inner);
                triangles[count][1] = vertex(ring, outer);
                triangles[count++][2] = vertex(ring, outer + 1);
                if (k + 1 < ring) {
                    triangles[count][0] = vertex(ring - 1, inner);
                    triangles[count][1] = vertex(ring, outer + 1);
                    triangles[count++][2] = vertex(ring - 1, inner + 1);
                }
            }
        }
    }
    check(count == TRIANGLES, "number of triangles");
    for (int place = 0; place < RIM; ++place) {
        hinges[place][0] = vertex(RINGS, place + RIM - 1);
        hinges[place][1] = vertex(RINGS, place);
        hinges[place][2] = vertex(RINGS, place + 1);
        rigidities[place] = 1e-5;
    }
}

static int32_t count_calls(double fraction, void* user) {
    check(fraction >= 0.0 && fraction <= 1.0, "progress between 0 and 1");
    check(user == &calls, "user pointer handed on");
    ++calls;
    return 1;
}

static int32_t stop(double fraction, void* user) {
    (void)fraction;
    (void)user;
    return 0;
}

static film_status create(const int32_t* corners, const film_constants* numbers, film_solver** solver) {
    const film_material material = {.membrane_stiffness = 50.0,
                                    .poisson_ratio = 0.3,
                                    .flexural_rigidity = 1e-6,
                                    .pressure = 1.0,
                                    .tension_field = 1};
    return film_create(VERTICES, rest[0], TRIANGLES, corners, fixed[0], NULL, NULL, RIM, hinges[0],
                       rigidities, &material, numbers, solver);
}

/* Two fields of loads at once: a push up at the middle, and none. */
static void push(film_solver* solver) {
    static double loads[VERTICES][5][2], moves[VERTICES][3][2];
    int32_t exact = -1;
    loads[0][2][0] = 1e-3;
    check(film_tangent_solve(solver, positions[0], directors[0], 2, loads[0][0], moves[0][0], &exact)
              == FILM_OK,
          "tangent");
    check(exact == 1, "at rest the exact Hessian is definite");
    check(moves[0][2][0] > 0.0, "the middle goes where it is pushed");
    for (int v = 0; v < VERTICES; ++v) {
        check(moves[v][0][1] == 0.0 && moves[v][1][1] == 0.0 && moves[v][2][1] == 0.0, "no load, no move");
        check(moves[v][2][0] <= moves[0][2][0], "the middle moves most");
        check(!fixed[v][2] || moves[v][2][0] == 0.0, "rim in its plane");
    }
    check(film_tangent_solve(solver, positions[0], directors[0], 0, loads[0][0], moves[0][0], &exact)
              == FILM_BAD_ARGUMENT,
          "no field");
    check(film_tangent_solve(solver, positions[0], directors[0], 2, NULL, moves[0][0], &exact)
              == FILM_BAD_ARGUMENT,
          "missing loads");
}

static void inflate(void) {
    const double levels[] = {6.0, 17.3, 50.0};
    const film_newton settings = {1e-6, 100};
    film_solver* solver = NULL;
    film_result result = {0, 0, 0};
    double parts[5] = {0.0};
    check(create(triangles[0], &constants, &solver) == FILM_OK, "create");

    check(film_solve(solver, positions[0], directors[0], 3, levels, &settings, stop, NULL, &result)
              == FILM_CANCELLED,
          "cancel");
    check(strlen(film_last_error()) > 0, "text of the error");
    check(positions[0][2] != 0.2, "last state kept when cancelled");
    check(film_solve(solver, positions[0], directors[0], 3, levels, &settings, count_calls, &calls, &result)
              == FILM_OK,
          "solve");
    check(result.converged == 1, "converged");
    check(calls == result.steps, "progress after each step");
    check(result.factorisations >= result.steps, "factorisations");
    check(film_energies(solver, positions[0], directors[0], parts) == FILM_OK, "energies");
    /* k = 100 over the radius: V = 1.23836 a^3 for both halves; 127 vertices hold some two per cent less */
    const double volume = -2.0 * parts[2], exact = 1.23836 / 8.0;
    printf("volume %.6f of %.6f in %d steps\n", volume, exact, (int)result.steps);
    check(volume > 0.965 * exact && volume < exact, "volume");
    check(parts[0] > 0.0 && parts[1] > 0.0 && parts[3] == 0.0 && parts[4] >= 0.0, "parts of the energy");
    for (int v = 0; v < VERTICES; ++v) {
        if (fixed[v][2])
            check(positions[v][2] == 0.0, "rim in its plane");
    }

    push(solver);
    const film_newton hurried = {1e-6, 1};
    check(film_solve(solver, positions[0], directors[0], 3, levels, &hurried, NULL, NULL, &result) == FILM_OK,
          "solve without progress");
    check(result.converged == 0 && result.steps == 1, "steps used up");

    positions[0][2] = NAN;
    check(film_solve(solver, positions[0], directors[0], 3, levels, &settings, NULL, NULL, &result)
              == FILM_NOT_FINITE,
          "start that is not finite");
    check(film_solve(solver, NULL, directors[0], 3, levels, &settings, NULL, NULL, &result)
              == FILM_BAD_ARGUMENT,
          "missing positions");
    check(film_solve(solver, positions[0], directors[0], 0, levels, &settings, NULL, NULL, &result)
              == FILM_BAD_ARGUMENT,
          "no levels");
    check(film_energies(NULL, positions[0], directors[0], parts) == FILM_BAD_ARGUMENT, "missing solver");
    film_destroy(solver);
}

/* A director whose bending is negative has no minimum at any tension. */
static void give_up(void) {
    const double levels[] = {50.0};
    const film_newton settings = {1e-6, 100};
    const film_material unstable = {
        .membrane_stiffness = 50.0, .poisson_ratio = 0.3, .flexural_rigidity = -1e-6, .tension_field = 1};
    film_solver* solver = NULL;
    film_result result = {0, 0, 0};
    check(film_create(VERTICES, rest[0], TRIANGLES, triangles[0], fixed[0], NULL, NULL, 0, NULL, NULL,
                      &unstable, &constants, &solver)
              == FILM_OK,
          "create what is unstable");
    check(film_solve(solver, positions[0], directors[0], 1, levels, &settings, NULL, NULL, &result)
              == FILM_OK,
          "solve what is unstable");
    check(result.converged == 0 && result.steps == 0 && result.factorisations > 10, "gives up");
    film_destroy(solver);
}

static void refuse(void) {
    static int32_t wrong[TRIANGLES][3];
    film_solver* solver = NULL;
    memcpy(wrong, triangles, sizeof wrong);
    wrong[3][1] = VERTICES;
    check(create(wrong[0], &constants, &solver) == FILM_BAD_ARGUMENT, "index out of range");
    wrong[3][1] = -1;
    check(create(wrong[0], &constants, &solver) == FILM_BAD_ARGUMENT, "negative index");
    check(create(NULL, &constants, &solver) == FILM_BAD_ARGUMENT, "missing triangles");
    check(create(triangles[0], NULL, &solver) == FILM_BAD_ARGUMENT, "missing constants");
    check(strstr(film_last_error(), "missing") != NULL, "text names the cause");
    const double nonsense[] = {0.0, -1.0, NAN, INFINITY, 1.0};
    for (size_t k = 0; k < sizeof nonsense / sizeof *nonsense; ++k) {
        film_constants numbers = constants;
        numbers.tension_growth = nonsense[k];
        check(create(triangles[0], &numbers, &solver) == FILM_BAD_ARGUMENT, "growth that does not grow");
    }
    check(strstr(film_last_error(), "constant") != NULL, "text names the cause");
    check(solver == NULL, "no solver after a failure");
    film_destroy(NULL);
}

int main(void) {
    check(film_abi_version() == FILM_ABI_VERSION, "version of the interface");
    make_disc();
    give_up();
    inflate();
    refuse();
    return failures ? EXIT_FAILURE : EXIT_SUCCESS;
}
