// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "shell.h"

namespace film {

// Whether the balloon is at rest as far as it can be seen: by its outline, which is the seam, and its volume.
// The last steps of a solve move only crumples, and neither of these. The same as in the NumPy solver.
class Convergence {
public:
    // tolerance: on the predicted decrease of the energy, relative.
    Convergence(const Shell& shell, double tolerance, const film_constants& constants);

    // After a step of so much of its length, from energy to next: true where this one and the one before
    // left the balloon as it was. Never without a seam, nor for a step that was held back, which says little.
    bool at_rest(const Vectors& before, const Vectors& after, const Energies& energy, const Energies& next,
                 double length, double decrement, bool held_back);

private:
    double movement(const Vectors& before, const Vectors& after) const;

    std::vector<int> seam_;
    double tolerance_;
    const film_constants& constants_;
    int steps_ = 0; // that left it as it was
};

} // namespace film
