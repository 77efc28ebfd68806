/* SPDX-License-Identifier: LGPL-2.1-or-later
 *
 * Spoils the arguments of the solver at random, for a program built with the sanitizers: each call must come
 * back with a status, and what it gives back with FILM_OK must be finite. Exits 0 when all is well.
 *
 * boundary_fuzz ROUNDS
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "film_solver.h"

/* CONSTANTS, from the compiler's command line: those of core/solver/c_interface.py in their order. */

enum { SIDE = 5, VERTICES = SIDE * SIDE, TRIANGLES = 2 * (SIDE - 1) * (SIDE - 1), RIM = 4 * (SIDE - 1) };

/* What a call is given; each round begins with a good square pillow. */
typedef struct {
    int32_t vertices, triangles, hinges, level_count;
    double rest[VERTICES][2], positions[VERTICES][3], directors[VERTICES][3], loads[VERTICES][3];
    int32_t corners[TRIANGLES][3], seam[RIM][3], tied[VERTICES];
    double rigidities[RIM], levels[2];
    uint8_t fixed[VERTICES][5];
    film_material material;
    film_newton settings;
    film_constants constants;
} problem;

static uint64_t state = 1;

static uint32_t pick(uint32_t count) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)(state >> 33) % count;
}

static double odd_number(void) {
    static const double values[] = {0.0, -0.0, -1.0, 1e-320, 1e-30, 1e30, 1e308, -1e308, 0.5, 2.0};
    switch (pick(4)) {
    case 0:
        return NAN;
    case 1:
        return pick(2) ? INFINITY : -INFINITY;
    default:
        return values[pick(sizeof values / sizeof *values)];
    }
}

static int32_t odd_index(void) {
    static const int32_t values[] = {-1, VERTICES, INT32_MAX, INT32_MIN};
    return pick(2) ? values[pick(4)] : (int32_t)pick(VERTICES);
}

static int32_t rim_vertex(int place) {
    const int side = place / (SIDE - 1), along = place % (SIDE - 1), last = SIDE - 1;
    switch (side) {
    case 0:
        return along;
    case 1:
        return along * SIDE + last;
    case 2:
        return last * SIDE + last - along;
    default:
        return (last - along) * SIDE;
    }
}

static void make_pillow(problem* p) {
    memset(p, 0, sizeof *p);
    p->vertices = VERTICES;
    p->triangles = TRIANGLES;
    p->hinges = RIM;
    p->level_count = 2;
    p->levels[0] = 5.0;
    p->levels[1] = 20.0;
    for (int32_t v = 0; v < VERTICES; ++v) {
        const double x = (double)(v % SIDE) / (SIDE - 1), y = (double)(v / SIDE) / (SIDE - 1);
        p->rest[v][0] = p->positions[v][0] = x;
        p->rest[v][1] = p->positions[v][1] = y;
        p->positions[v][2] = 2.0 * x * (1.0 - x) * y * (1.0 - y);
        p->directors[v][2] = 1.0;
        p->fixed[v][2] = x == 0.0 || x == 1.0 || y == 0.0 || y == 1.0;
        p->tied[v] = v;
    }
    int count = 0;
    for (int32_t row = 0; row + 1 < SIDE; ++row) {
        for (int32_t column = 0; column + 1 < SIDE; ++column) {
            const int32_t a = row * SIDE + column;
            const int32_t two[2][3] = {{a, a + 1, a + SIDE}, {a + 1, a + SIDE + 1, a + SIDE}};
            memcpy(p->corners[count], two, sizeof two);
            count += 2;
        }
    }
    for (int place = 0; place < RIM; ++place) {
        p->seam[place][0] = rim_vertex((place + RIM - 1) % RIM);
        p->seam[place][1] = rim_vertex(place);
        p->seam[place][2] = rim_vertex((place + 1) % RIM);
        p->rigidities[place] = 1e-5;
    }
    p->material.membrane_stiffness = 20.0;
    p->material.poisson_ratio = 0.3;
    p->material.flexural_rigidity = 1e-5;
    p->material.pressure = 1.0;
    p->material.across = p->material.shear = 0.5;
    p->material.orthotropic = (int32_t)pick(2);
    p->material.tension_field = (int32_t)pick(4) > 0;
    p->settings.tolerance = 1e-5;
    p->settings.max_steps = 12;
    p->constants = (film_constants){CONSTANTS};
}

/* What was too large for its array would be the caller's lie and is left alone. */
static void spoil_size(problem* p) {
    switch (pick(5)) {
    case 0:
        p->vertices = (int32_t)pick(VERTICES + 1) - (int32_t)pick(2) * VERTICES;
        break;
    case 1:
        p->triangles = (int32_t)pick(TRIANGLES + 1) - (int32_t)pick(2) * TRIANGLES;
        break;
    case 2:
        p->hinges = (int32_t)pick(RIM + 1) - (int32_t)pick(2) * RIM;
        break;
    case 3:
        p->level_count = (int32_t)pick(4) - 1;
        break;
    default:
        p->settings.max_steps = pick(2) ? 0 : -(int32_t)pick(100);
    }
}

static void spoil_number(problem* p) {
    const struct {
        double* numbers;
        uint32_t count;
    } arrays[] = {{p->rest[0], 2 * VERTICES},
                  {p->positions[0], 3 * VERTICES},
                  {p->directors[0], 3 * VERTICES},
                  {p->loads[0], 3 * VERTICES},
                  {p->rigidities, RIM},
                  {p->levels, 2},
                  {&p->material.membrane_stiffness, 7},
                  {&p->constants.level_tolerance, 17},
                  {&p->settings.tolerance, 1}};
    const uint32_t k = pick(sizeof arrays / sizeof *arrays);
    arrays[k].numbers[pick(arrays[k].count)] = odd_number();
}

static void spoil_index(problem* p) {
    switch (pick(4)) {
    case 0:
        p->corners[pick(TRIANGLES)][pick(3)] = odd_index();
        break;
    case 1:
        p->seam[pick(RIM)][pick(3)] = odd_index();
        break;
    case 2:
        p->tied[pick(VERTICES)] = odd_index();
        break;
    default:
        (&p->constants.still_steps)[pick(3)] = -(int32_t)pick(3);
    }
}

/* Spoils one thing. */
static void spoil(problem* p, const void* missing[16]) {
    switch (pick(18)) {
    case 0:
        missing[pick(16)] = p;
        break;
    case 1:
        memset(p->fixed, (int)pick(256), sizeof p->fixed);
        break;
    case 2:
        p->fixed[pick(VERTICES)][pick(5)] ^= 1;
        break;
    case 3:
    case 4:
    case 5:
    case 6:
    case 7:
        spoil_size(p);
        break;
    case 8:
    case 9:
    case 10:
        spoil_index(p);
        break;
    default:
        spoil_number(p);
    }
}

static int32_t perhaps_stop(double fraction, void* user) {
    (void)fraction;
    (void)user;
    return pick(50) > 0;
}

#define GIVEN(index, array) (missing[index] ? NULL : (array))

static int try_once(unsigned long round, unsigned long counts[5]) {
    static problem p;
    const void* missing[16] = {NULL};
    film_solver* solver = NULL;
    film_result result = {0, 0, 0};
    double parts[5];
    state = round;
    make_pillow(&p);
    for (uint32_t k = 1 + pick(2); k > 0; --k)
        spoil(&p, missing);
    film_status status = film_create(p.vertices, GIVEN(0, p.rest[0]), p.triangles, GIVEN(1, p.corners[0]),
                                     GIVEN(2, p.fixed[0]), GIVEN(3, p.loads[0]), GIVEN(4, p.tied), p.hinges,
                                     GIVEN(5, p.seam[0]), GIVEN(6, p.rigidities), GIVEN(7, &p.material),
                                     GIVEN(15, &p.constants), missing[8] ? NULL : &solver);
    if (status == FILM_OK) {
        film_energies(solver, GIVEN(9, p.positions[0]), GIVEN(10, p.directors[0]), parts);
        status = film_solve(missing[11] ? NULL : solver, GIVEN(9, p.positions[0]), GIVEN(10, p.directors[0]),
                            p.level_count, GIVEN(12, p.levels), GIVEN(13, &p.settings), perhaps_stop, NULL,
                            GIVEN(14, &result));
        film_destroy(solver);
    }
    if (status < FILM_OK || status > FILM_OUT_OF_MEMORY) {
        fprintf(stderr, "round %lu: status %d\n", round, (int)status);
        return 0;
    }
    ++counts[status];
    if (status != FILM_OK) {
        if (strlen(film_last_error()) == 0)
            fprintf(stderr, "round %lu: no text\n", round);
        return strlen(film_last_error()) > 0;
    }
    for (int32_t v = 0; v < p.vertices; ++v) {
        for (int k = 0; k < 3; ++k) {
            if (!isfinite(p.positions[v][k]) || !isfinite(p.directors[v][k])) {
                fprintf(stderr, "round %lu: not finite at vertex %d\n", round, (int)v);
                return 0;
            }
        }
    }
    return 1;
}

int main(int count, char** words) {
    const unsigned long rounds = count > 1 ? strtoul(words[1], NULL, 10) : 1000;
    unsigned long counts[5] = {0}, bad = 0;
    for (unsigned long round = 1; round <= rounds; ++round)
        bad += !try_once(round, counts);
    printf("%lu ok, %lu bad arguments, %lu not finite, %lu cancelled, %lu out of memory\n", counts[0],
           counts[1], counts[2], counts[3], counts[4]);
    return bad ? EXIT_FAILURE : EXIT_SUCCESS;
}
