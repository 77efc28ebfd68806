// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tangent.h"

#include <algorithm>
#include <stdexcept>

#include "cholesky/cholesky.h"
#include "threads.h"

namespace film {

bool tangent_solve(Shell shell, const State& state, const film_constants& constants, int fields,
                   const double* loads, double* moves) {
    BlockMatrix hessian = shell.hessian();
    cholesky::Factorisation factorisation(hessian.pattern(), shell.blocks(), threads_for(shell.vertices()));
    const Eigen::VectorXd shift = constants.shift * shell.masses(constants.director_shift);
    const Frames frames(state.directors);
    Eigen::VectorXd gradient;
    const auto is_definite = [&](bool exact, double tension) {
        shell.set_exact(exact);
        shell.set_tension(tension);
        shell.derivatives(state, frames, gradient, hessian);
        return factorisation.factorise(hessian.values().data(), shift.data());
    };
    shell.set_slack_stiffness(0.0);
    const bool exact = is_definite(true, 0.0);
    double tension = 0.0;
    while (!exact && !is_definite(false, tension)) {
        if (tension >= constants.largest_tension)
            throw std::invalid_argument("the balloon is not near rest");
        tension = std::max(constants.tension_growth * tension, constants.first_tension);
    }
    Eigen::MatrixXd columns = shell.gathered(loads, fields);
    factorisation.solve(columns.data(), fields);
    shell.spread(columns, moves);
    return exact;
}

} // namespace film
