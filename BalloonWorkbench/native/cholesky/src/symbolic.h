// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "cholesky/cholesky.h"
#include "front_kernels.h"

namespace cholesky {

// The symbolic factorisation, which all matrices of a pattern share: a multifrontal method (Duff and Reid
// 1983) whose fronts are assembled from entries of the matrix and from the updates that their children leave.
struct Symbolic {
    // Neighbouring numbers of a column of the matrix and their place in the panel of a front, there along a
    // column, or along a row when the order of elimination has swapped the two.
    struct Entries {
        int source, target;
        short length;
        bool along_row;
    };
    // Neighbouring updates of a front and their place in the parent's rows.
    struct Transfer {
        int source, target, length;
    };
    struct Front {
        FrontShape shape;
        int pivots, first_unknown; // in the order of elimination
        int parent, first_child, children;
        int first_entries, last_entries;
        int first_transfer, transfers;
        size_t factor, vector;   // where its parts begin
        double time, time_below; // [ns] about, of the front and of its subtree
    };

    Symbolic(const Pattern& lower, const Blocks& blocks);

    std::vector<Front> fronts; // children before parents, whole subtrees together
    std::vector<int> children; // of all fronts
    std::vector<Entries> entries;
    std::vector<Transfer> transfers;
    std::vector<int> unknowns; // in the order of elimination
    size_t factor_size = 0, vector_size = 0;

    size_t bytes() const;
};

} // namespace cholesky
