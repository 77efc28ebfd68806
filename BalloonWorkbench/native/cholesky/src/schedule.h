// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "symbolic.h"

namespace cholesky {

// Who works on which fronts: subtrees are mapped to threads, and all threads share the fronts above them
// (Geist and Ng 1989). And where each front leaves its update: in memory of the thread at work, or, where
// others will take it, in memory of all. Nothing of the result depends on it.
struct Schedule {
    // A whole subtree, the fronts first .. last - 1: for one thread.
    struct Subtree {
        int first, last;
    };

    // For one thread, or for a matrix too small to share, all is one subtree.
    Schedule(const Symbolic& symbolic, int threads);

    bool is_parallel() const { return !shared_fronts.empty(); }

    std::vector<Subtree> subtrees;  // the longest first
    std::vector<int> shared_fronts; // the fronts above them, for all threads together
    std::vector<size_t> update_at;  // from thread_size on it is in the memory of all
    size_t thread_size = 0, shared_size = 0;

private:
    void choose_subtrees(const Symbolic& symbolic, int threads);
    void place_updates(const Symbolic& symbolic);
};

} // namespace cholesky
