// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "cholesky_plan.h"

namespace film {

// Who works on which fronts, and where each leaves its update: in memory of the thread at work, or, where
// others will take it, in memory of all. Nothing of the result depends on it.
struct Schedule {
    // A whole subtree, the fronts first .. last - 1: for one thread.
    struct Branch {
        int first, last;
    };

    // For one thread, or for a matrix too small to share, all is one branch.
    Schedule(const CholeskyPlan& plan, int threads);

    bool shared() const { return !trunk.empty(); }

    std::vector<Branch> branches;  // the longest first
    std::vector<int> trunk;        // the fronts above them, for all threads together
    std::vector<size_t> update_at; // from thread_size on it is in the memory of all
    size_t thread_size = 0, shared_size = 0;

private:
    void grow_branches(const CholeskyPlan& plan, int threads);
    void place_updates(const CholeskyPlan& plan);
};

} // namespace film
