// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chrono>
#include <functional>

#include "cholesky_plan.h"
#include "numbers.h"
#include "schedule.h"
#include "workers.h"

namespace film {

// Sparse Cholesky factorisation of matrices that share a pattern; factorisations and solves allocate nothing.
// The result does not depend on the number of threads, to the last bit. For one caller at a time.
class Cholesky {
public:
    // The lower triangle gives the pattern, with the diagonal first in each column.
    Cholesky(SymmetricMatrix lower, const Blocks& blocks, int threads);

    // Factors the matrix with these values in its lower triangle, plus a diagonal one unless null; false when
    // it is not positive definite.
    bool factorise(const double* values, const double* diagonal);

    // Replaces the right-hand side by the solution, after a factorisation that succeeded.
    void solve(double* right_hand_side);

    // Both; faster, for one half of the solution is done while the factor is still in cache. Leaves the
    // right-hand side when the matrix is not positive definite.
    bool factorise_and_solve(const double* values, const double* diagonal, double* right_hand_side);

    // Asks, on the calling thread and now and then during a factorisation that takes long, whether to go on;
    // where it may not, the matrix counts as not positive definite.
    void ask(std::function<bool()> question);
    bool stopped() const { return stopped_; } // by the answer, in the last factorisation

    size_t factor_entries() const { return plan_.factor_size; } // with the zeros that are stored
    size_t bytes() const;                                       // of all memory held

private:
    struct Team; // threads that work on a front together

    bool run(const double* values, const double* diagonal, double* right_hand_side);
    void work(int thread);
    bool go_up(int index, const Team& team);
    bool factor(int index, const Team& team);
    void assemble(int index, const Team& team);
    void add_updates(int index, const Team& team, bool to_pivots, int first, int last, double* target);
    bool factor_panel(int index, const Team& team);
    double* update(int index, const Team& team);
    bool may_go_on();
    void forward(int index);
    void backward(int index, double* scratch);

    CholeskyPlan plan_;
    Schedule schedule_;
    const FrontKernels& kernels_;
    Numbers factor_, updates_, vectors_;
    std::vector<Numbers> panels_, stacks_; // of each thread
    Workers workers_;
    std::function<bool()> question_;
    std::chrono::steady_clock::time_point asked_;
    bool stopped_ = false;
    // for the work at hand
    const double* values_ = nullptr; // null when there is nothing to factor
    const double* diagonal_ = nullptr;
    double* right_hand_side_ = nullptr;             // null when there is nothing to solve
    std::atomic<size_t> next_up_{0}, next_down_{0}; // branches to take
    std::atomic<bool> definite_{true};
};

} // namespace film
