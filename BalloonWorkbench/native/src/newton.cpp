// SPDX-License-Identifier: LGPL-2.1-or-later
#include "newton.h"

#include <algorithm>
#include <cmath>

#include "cholesky.h"
#include "sight.h"

namespace film {
namespace {

// The same numbers as in core/solver/equilibrium/newton.py: both must take the same steps.
constexpr double kLevelTolerance = 0.02;
constexpr double kShift = 1e-6, kDirectorShift = 0.1;
constexpr double kFirstTension = 0.03, kHeldBack = 0.1, kLargestTension = 1e12;
constexpr double kTensionGrowth = 8.0, kTensionDecay = 0.2, kNeedDecay = 0.5;
constexpr double kSufficient = 2e-4, kShortest = 1e-3;

double next_tension(double tension, double length) {
    if (length == 1.0)
        return kTensionDecay * tension;
    if (length < 0.3)
        return std::max(tension, 0.1 * kFirstTension) * std::min(0.5 / length, kTensionGrowth);
    return tension;
}

} // namespace

film_result newton(Shell& shell, State& state, const std::vector<double>& levels, const film_newton& settings,
                   const std::function<bool(double)>& progress) {
    film_result result{0, 0, 0};
    BlockMatrix hessian = shell.hessian();
    Cholesky factor(hessian.pattern(), shell.blocks(), Workers::usual_count());
    double done = 0.0;
    factor.ask([&] { return progress(done); });
    Eigen::VectorXd gradient, step;
    const Eigen::VectorXd shift = kShift * shell.masses(kDirectorShift);
    Sight sight(shell, settings.tolerance);
    double tension = 0.0, needed = 0.0; // needed for a definite Hessian, not long ago
    for (size_t level = 0; level < levels.size(); ++level) {
        shell.set_membrane_stiffness(levels[level]);
        const bool last = level + 1 == levels.size();
        const double tolerance = last ? settings.tolerance : kLevelTolerance;
        Energies energy = shell.energies(state);
        if (!std::isfinite(energy.total()))
            throw NotFinite("the start has no finite energy");
        bool level_done = false;
        while (!level_done && result.steps < settings.max_steps) {
            const Frames frames(state.directors);
            for (;;) { // with the least tried tension that makes the Hessian positive definite
                shell.set_tension(tension);
                shell.derivatives(state, frames, gradient, hessian);
                step = -gradient;
                ++result.factorisations;
                if (factor.factorise_and_solve(hessian.values().data(), shift.data(), step.data()))
                    break;
                if (factor.stopped())
                    throw Cancelled("stopped by the caller");
                if (tension >= kLargestTension)
                    return result;
                tension = needed = std::max(kTensionGrowth * tension, kFirstTension);
            }
            const double decrement = -0.5 * gradient.dot(step);
            ++result.steps;

            double length = 1.0;
            State next;
            Energies trial;
            for (; length >= kShortest; length *= 0.5) {
                next = shell.moved(state, frames, step, length);
                trial = shell.energies(next);
                if (trial.total() <= energy.total() - kSufficient * length * decrement)
                    break;
            }
            if (length < kShortest) {
                level_done = decrement <= tolerance * std::abs(energy.total());
                tension = std::min(std::max(kTensionGrowth * kTensionGrowth * tension, kFirstTension),
                                   kLargestTension);
            } else {
                const bool held_back = last && tension > kHeldBack;
                const bool at_rest = sight.at_rest(state.positions, next.positions, energy, trial, length,
                                                   decrement, held_back);
                state = std::move(next);
                energy = trial;
                const bool small = decrement <= tolerance * std::abs(energy.total());
                level_done = !held_back && (small || at_rest);
                needed *= kNeedDecay;
                tension = std::max(next_tension(tension, length), needed);
            }
            result.converged = last && level_done;
            const double part =
                std::min(1.0, tolerance * std::abs(energy.total()) / std::max(decrement, 1e-300));
            done = (static_cast<double>(level) + part) / static_cast<double>(levels.size());
            if (!progress(done))
                throw Cancelled("stopped by the caller");
        }
    }
    return result;
}

} // namespace film
