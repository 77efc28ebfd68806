// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>

#include "aligned_array.h"
#include "schedule.h"
#include "symbolic.h"
#include "thread_pool.h"

namespace cholesky {

// Factor and solutions by the fronts of a tree: up it the factor and the forward substitution, down it the
// backward substitution.
class Multifrontal {
public:
    Multifrontal(Pattern lower, const Blocks& blocks, int threads);

    // Factors where there are values, solves where there is a right-hand side.
    bool run(const double* values, const double* diagonal, double* right_hand_side);
    // Replaces right-hand sides, one after the other, by their solutions.
    void solve(double* right_hand_sides, int count);
    void set_interrupt(std::function<bool()> may_go_on);
    bool interrupted() const { return interrupted_; }
    size_t factor_entries() const { return symbolic_.factor_size; }
    size_t bytes() const;

private:
    struct Team; // threads that work on a front together

    void work(int thread);
    bool go_up(int index, const Team& team);
    bool factor(int index, const Team& team);
    void assemble(int index, const Team& team);
    void add_updates(int index, const Team& team, bool to_pivots, int first, int last, double* target);
    bool factor_panel(int index, const Team& team);
    double* update(int index, const Team& team);
    bool goes_on();
    void forward(int index, double* vectors, const double* right_hand_side);
    void backward(int index, double* vectors, double* right_hand_side, double* scratch);

    Symbolic symbolic_;
    Schedule schedule_;
    const FrontKernels& kernels_;
    AlignedArray factor_, updates_, vectors_;
    std::vector<AlignedArray> panels_, stacks_; // of each thread
    std::unique_ptr<AlignedArray> many_;        // vectors of the right-hand sides that are solved together
    ThreadPool pool_;
    std::function<bool()> may_go_on_;
    std::chrono::steady_clock::time_point last_asked_;
    bool interrupted_ = false;
    // for the work at hand
    const double* values_ = nullptr; // null when there is nothing to factor
    const double* diagonal_ = nullptr;
    double* right_hand_side_ = nullptr;             // null when there is nothing to solve
    std::atomic<size_t> next_up_{0}, next_down_{0}; // subtrees to take
    std::atomic<bool> definite_{true};
};

} // namespace cholesky
