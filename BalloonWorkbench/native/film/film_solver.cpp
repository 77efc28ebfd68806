// SPDX-License-Identifier: LGPL-2.1-or-later
#include "film_solver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <memory>
#include <new>
#include <string>

#include "newton.h"
#include "tangent.h"
#include "threads.h"

struct film_solver {
    film::Shell shell;
    film_constants constants;
};

namespace {

thread_local std::string last_error;

film_status fail(film_status status, const char* text) {
    last_error = text;
    return status;
}

// No exception may cross the C ABI.
template <typename Work>
film_status guarded(const Work& work) {
    try {
        work();
        return FILM_OK;
    } catch (const film::NotFinite& error) {
        return fail(FILM_NOT_FINITE, error.what());
    } catch (const film::Cancelled& error) {
        return fail(FILM_CANCELLED, error.what());
    } catch (const std::bad_alloc&) {
        return fail(FILM_OUT_OF_MEMORY, "out of memory");
    } catch (const std::exception& error) {
        return fail(FILM_BAD_ARGUMENT, error.what());
    }
}

bool any_missing(std::initializer_list<const void*> arrays) {
    return std::find(arrays.begin(), arrays.end(), nullptr) != arrays.end();
}

bool indices_valid(const int32_t* indices, int64_t count, int32_t vertices) {
    for (int64_t i = 0; i < count; ++i) {
        if (indices[i] < 0 || indices[i] >= vertices)
            return false;
    }
    return true;
}

bool ties_valid(const int32_t* tied, int32_t vertices) {
    for (int32_t vertex = 0; vertex < vertices; ++vertex) {
        if (tied[vertex] < 0 || tied[vertex] > vertex)
            return false;
    }
    return true;
}

// A constant of another size would make an iteration endless.
bool constants_valid(const film_constants& constants) {
    std::array<double, offsetof(film_constants, still_steps) / sizeof(double)> numbers;
    std::memcpy(numbers.data(), &constants, sizeof numbers);
    return std::all_of(numbers.begin(), numbers.end(), [](double x) { return x > 0.0 && std::isfinite(x); })
           && constants.tension_growth > 1.0 && constants.still_steps > 0 && constants.directions > 0
           && constants.direction_steps > 0;
}

film::State state_of(const double* positions, const double* directors, int vertices) {
    return {Eigen::Map<const film::Vectors>(positions, vertices, 3),
            Eigen::Map<const film::Vectors>(directors, vertices, 3)};
}

} // namespace

int32_t film_abi_version(void) {
    return FILM_ABI_VERSION;
}

void film_set_threads(int32_t count) {
    film::set_threads(count);
}

const char* film_last_error(void) {
    return last_error.c_str();
}

film_status film_create(int32_t vertices, const double* rest_positions, int32_t triangles,
                        const int32_t* triangle_corners, const uint8_t* fixed, const double* loads,
                        const int32_t* tied, int32_t hinges, const int32_t* seam_hinges,
                        const double* hinge_rigidities, const film_material* material,
                        const film_constants* constants, film_solver** solver) {
    if (vertices < 3 || triangles < 1 || hinges < 0)
        return fail(FILM_BAD_ARGUMENT, "the mesh is empty");
    if (any_missing({rest_positions, triangle_corners, fixed, material, constants, solver})
        || (hinges > 0 && any_missing({seam_hinges, hinge_rigidities})))
        return fail(FILM_BAD_ARGUMENT, "an array is missing");
    if (!indices_valid(triangle_corners, 3 * int64_t{triangles}, vertices)
        || !indices_valid(seam_hinges, 3 * int64_t{hinges}, vertices))
        return fail(FILM_BAD_ARGUMENT, "a vertex index is out of range");
    if (tied && !ties_valid(tied, vertices))
        return fail(FILM_BAD_ARGUMENT, "a vertex is tied to one behind it");
    if (!constants_valid(*constants))
        return fail(FILM_BAD_ARGUMENT, "a constant of the iteration makes no sense");
    return guarded([&] {
        *solver =
            new film_solver{film::Shell(vertices, rest_positions, triangles, triangle_corners, fixed, loads,
                                        tied, hinges, seam_hinges, hinge_rigidities, *material, *constants),
                            *constants};
    });
}

void film_destroy(film_solver* solver) {
    delete solver;
}

film_status film_energies(film_solver* solver, const double* positions, const double* directors,
                          double* parts) {
    if (any_missing({solver, positions, directors, parts}))
        return fail(FILM_BAD_ARGUMENT, "an array is missing");
    return guarded([&] {
        const film::Energies e =
            solver->shell.energies(state_of(positions, directors, solver->shell.vertices()));
        const double values[5] = {e.membrane, e.bending, e.pressure, e.load, e.seam};
        std::copy(values, values + 5, parts);
    });
}

film_status film_solve(film_solver* solver, double* positions, double* directors, int32_t level_count,
                       const double* levels, const film_newton* settings, film_progress progress, void* user,
                       film_result* result) {
    if (any_missing({solver, positions, directors, levels, settings, result}) || level_count < 1)
        return fail(FILM_BAD_ARGUMENT, "an array is missing");
    return guarded([&] {
        const int vertices = solver->shell.vertices();
        film::State state = state_of(positions, directors, vertices);
        const auto give_back = [&] {
            Eigen::Map<film::Vectors>(positions, vertices, 3) = state.positions;
            Eigen::Map<film::Vectors>(directors, vertices, 3) = state.directors;
        };
        try {
            *result = film::newton(solver->shell, state, std::vector<double>(levels, levels + level_count),
                                   *settings, solver->constants, [&](double fraction) {
                                       return progress == nullptr || progress(fraction, user) != 0;
                                   });
        } catch (const film::Cancelled&) {
            give_back();
            throw;
        }
        give_back();
    });
}

film_status film_tangent_solve(film_solver* solver, const double* positions, const double* directors,
                               int32_t fields, const double* loads, double* moves, int32_t* exact) {
    if (any_missing({solver, positions, directors, loads, moves, exact}) || fields < 1)
        return fail(FILM_BAD_ARGUMENT, "an array is missing");
    return guarded([&] {
        const film::State state = state_of(positions, directors, solver->shell.vertices());
        *exact = film::tangent_solve(solver->shell, state, solver->constants, fields, loads, moves) ? 1 : 0;
    });
}
