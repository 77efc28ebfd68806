// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <stdexcept>
#include <vector>

#include "shell.h"

namespace film {

struct NotFinite : std::runtime_error {
    using std::runtime_error::runtime_error;
};
struct Cancelled : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Brings the film to rest through the membrane stiffnesses in levels; state holds the start and the result.
// progress(fraction) returning false cancels. The same iteration as in the NumPy solver.
film_result newton(Shell& shell, State& state, const std::vector<double>& levels, const film_newton& settings,
                   const film_constants& constants, const std::function<bool(double)>& progress);

} // namespace film
