// SPDX-License-Identifier: LGPL-2.1-or-later
#include "newton.h"

#include <algorithm>
#include <cmath>

#include "cholesky/cholesky.h"
#include "convergence.h"
#include "threads.h"

namespace film {
namespace {

// The end of a line search; shorter than the shortest length when none was good enough.
struct Trial {
    double length = 1.0;
    State state;
    Energies energy;
};

// One solve.
class Iteration {
public:
    Iteration(Shell& shell, State& state, const film_newton& settings, const film_constants& constants,
              const std::function<bool(double)>& progress)
        : shell_(shell), state_(state), settings_(settings), constants_(constants), progress_(progress),
          hessian_(shell.hessian()),
          factorisation_(hessian_.pattern(), shell.blocks(), threads_for(shell.vertices())),
          shift_(constants.shift * shell.masses(constants.director_shift)),
          convergence_(shell, settings.tolerance, constants),
          slack_stiffness_(shell.in_space() ? constants.slack_stiffness : 0.0) {
        factorisation_.set_interrupt([this] { return progress_(done_); });
    }

    film_result run(const std::vector<double>& levels) {
        for (size_t level = 0; level < levels.size() && !stuck_; ++level) {
            shell_.set_membrane_stiffness(levels[level]);
            shell_.set_slack_stiffness(slack_stiffness_);
            energy_ = shell_.energies(state_);
            if (!std::isfinite(energy_.total()))
                throw NotFinite("the start has no finite energy");
            run_level(level, levels.size());
        }
        return result_;
    }

private:
    void run_level(size_t level, size_t count) {
        const bool last = level + 1 == count;
        const double tolerance = last ? settings_.tolerance : constants_.level_tolerance;
        for (bool level_done = false; !level_done && result_.steps < settings_.max_steps;) {
            const Frames frames(state_.directors);
            stuck_ = !find_step(frames);
            if (stuck_)
                return;
            const double decrement = -0.5 * gradient_.dot(step_);
            ++result_.steps;
            level_done = take(line_search(frames, decrement), decrement, tolerance, last);
            result_.converged = last && level_done;
            const double part =
                std::min(1.0, tolerance * std::abs(energy_.total()) / std::max(decrement, 1e-300));
            done_ = (static_cast<double>(level) + part) / static_cast<double>(count);
            if (!progress_(done_))
                throw Cancelled("stopped by the caller");
        }
    }

    // Newton's step with the least tried tension that makes the Hessian positive definite; false when none
    // does.
    bool find_step(const Frames& frames) {
        for (;;) {
            shell_.set_tension(tension_);
            shell_.derivatives(state_, frames, gradient_, hessian_);
            step_ = -gradient_;
            ++result_.factorisations;
            if (factorisation_.factorise_and_solve(hessian_.values().data(), shift_.data(), step_.data()))
                return true;
            if (factorisation_.interrupted())
                throw Cancelled("stopped by the caller");
            if (tension_ >= constants_.largest_tension)
                return false;
            tension_ = needed_ = std::max(constants_.tension_growth * tension_, constants_.first_tension);
        }
    }

    Trial line_search(const Frames& frames, double decrement) const {
        Trial trial;
        for (; trial.length >= constants_.shortest; trial.length *= 0.5) {
            trial.state = shell_.moved(state_, frames, step_, trial.length);
            trial.energy = shell_.energies(trial.state);
            if (trial.energy.total() <= energy_.total() - constants_.sufficient * trial.length * decrement)
                break;
        }
        return trial;
    }

    // Moves on and chooses the next tension; whether the level is done.
    bool take(Trial trial, double decrement, double tolerance, bool last) {
        const auto is_small = [&] { return decrement <= tolerance * std::abs(energy_.total()); };
        if (trial.length < constants_.shortest) {
            const double growth = constants_.tension_growth;
            tension_ = std::min(std::max(growth * growth * tension_, constants_.first_tension),
                                constants_.largest_tension);
            return is_small();
        }
        const bool held_back = last && tension_ > constants_.held_back;
        const bool at_rest = convergence_.at_rest(state_.positions, trial.state.positions, energy_,
                                                  trial.energy, trial.length, decrement, held_back);
        state_ = std::move(trial.state);
        energy_ = trial.energy;
        needed_ *= constants_.need_decay;
        tension_ = std::max(next_tension(trial.length), needed_);
        const double unrest =
            decrement / (constants_.slack_fades * std::max(std::abs(energy_.total()), 1e-300));
        shell_.set_slack_stiffness(slack_stiffness_ * std::min(1.0, unrest));
        return !held_back && (is_small() || at_rest);
    }

    double next_tension(double length) const {
        if (length == 1.0)
            return constants_.tension_decay * tension_;
        if (length < constants_.short_step)
            return std::max(tension_, constants_.least_tension)
                   * std::min(constants_.middling_step / length, constants_.tension_growth);
        return tension_;
    }

    Shell& shell_;
    State& state_;
    const film_newton& settings_;
    const film_constants& constants_;
    const std::function<bool(double)>& progress_;
    BlockMatrix hessian_;
    cholesky::Factorisation factorisation_;
    Eigen::VectorXd gradient_, step_;
    const Eigen::VectorXd shift_;
    Convergence convergence_;
    const double slack_stiffness_;
    Energies energy_;
    double tension_ = 0.0, needed_ = 0.0; // needed for a definite Hessian, not long ago
    double done_ = 0.0;                   // of all the work
    bool stuck_ = false;                  // the Hessian is indefinite at any tension
    film_result result_{0, 0, 0};
};

} // namespace

film_result newton(Shell& shell, State& state, const std::vector<double>& levels, const film_newton& settings,
                   const film_constants& constants, const std::function<bool(double)>& progress) {
    return Iteration(shell, state, settings, constants, progress).run(levels);
}

} // namespace film
