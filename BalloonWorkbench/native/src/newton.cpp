// SPDX-License-Identifier: LGPL-2.1-or-later
#include "newton.h"

#include <algorithm>
#include <cmath>

#include "cholesky.h"

namespace film {
namespace {

// The same numbers as in core/solver/newton.py: both must take the same steps.
constexpr double kLevelTolerance = 0.02;
constexpr double kShift = 1e-6, kDirectorShift = 0.1;
constexpr double kFirstTension = 0.03, kLargestTension = 1e12;
constexpr double kTensionGrowth = 8.0, kTensionDecay = 0.2;
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
    double tension = 0.0;
    for (size_t level = 0; level < levels.size(); ++level) {
        shell.set_membrane_stiffness(levels[level]);
        const bool last = level + 1 == levels.size();
        const double tolerance = last ? settings.tolerance : kLevelTolerance;
        double energy = shell.energies(state).total();
        if (!std::isfinite(energy))
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
                tension = std::max(kTensionGrowth * tension, kFirstTension);
            }
            const double decrement = -0.5 * gradient.dot(step);
            ++result.steps;

            double length = 1.0, trial = energy;
            State next;
            for (; length >= kShortest; length *= 0.5) {
                next = shell.moved(state, frames, step, length);
                trial = shell.energies(next).total();
                if (trial <= energy - kSufficient * length * decrement)
                    break;
            }
            if (length < kShortest) {
                level_done = decrement <= tolerance * std::abs(energy);
                tension = std::min(std::max(kTensionGrowth * kTensionGrowth * tension, kFirstTension),
                                   kLargestTension);
            } else {
                state = std::move(next);
                energy = trial;
                level_done = decrement <= tolerance * std::abs(energy);
                tension = next_tension(tension, length);
            }
            result.converged = last && level_done;
            const double part = std::min(1.0, tolerance * std::abs(energy) / std::max(decrement, 1e-300));
            done = (static_cast<double>(level) + part) / static_cast<double>(levels.size());
            if (!progress(done))
                throw Cancelled("stopped by the caller");
        }
    }
    return result;
}

} // namespace film
