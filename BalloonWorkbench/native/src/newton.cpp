// SPDX-License-Identifier: LGPL-2.1-or-later
#include "newton.h"

#include <algorithm>
#include <cmath>

#include "cholesky.h"

namespace film {
namespace {

// The same numbers as in core/solver/newton.py: both must take the same steps.
constexpr double kLevelTolerance = 0.02;
constexpr double kSmallestShift = 1e-6, kFirstShift = 0.3, kLargestShift = 1e12;
constexpr double kShiftGrowth = 8.0, kShiftDecay = 0.2, kDirectorShift = 0.1;
constexpr double kSufficient = 2e-4, kShortest = 1e-3;

double next_shift(double shift, double length) {
    if (length == 1.0)
        return std::max(shift * kShiftDecay, kSmallestShift);
    if (length < 0.3)
        return std::max(shift, 0.1 * kFirstShift) * std::min(0.5 / length, kShiftGrowth);
    return shift;
}

// The Newton step with the smallest tried shift that makes the Hessian positive definite; false when none
// does.
bool find_step(Cholesky& factor, const BlockMatrix& hessian, const Eigen::VectorXd& gradient,
               const Eigen::VectorXd& mass, double& shift, int32_t& factorisations, Eigen::VectorXd& step) {
    Eigen::VectorXd diagonal;
    step = -gradient;
    for (;;) {
        diagonal = shift * mass;
        ++factorisations;
        if (factor.factorise_and_solve(hessian.values().data(), diagonal.data(), step.data()))
            return true;
        if (factor.stopped())
            throw Cancelled("stopped by the caller");
        shift = std::max(shift * kShiftGrowth, kFirstShift);
        if (!(shift <= kLargestShift))
            return false;
    }
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
    const Eigen::VectorXd mass = shell.masses(kDirectorShift);
    double shift = kSmallestShift;
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
            shell.derivatives(state, frames, gradient, hessian);
            if (!find_step(factor, hessian, gradient, mass, shift, result.factorisations, step))
                return result;
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
                shift = std::min(std::max(shift * kShiftGrowth * kShiftGrowth, kFirstShift), kLargestShift);
            } else {
                state = std::move(next);
                energy = trial;
                level_done = decrement <= tolerance * std::abs(energy);
                shift = next_shift(shift, length);
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
