// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "graph.h"

namespace cholesky {

// A dense part of the factor: neighbouring columns (pivots) that share their rows. Counts are of unknowns.
struct Front {
    int first_vertex, vertices; // pivots: places in the order
    int first_row, rows;        // the other vertices: a range of AssemblyTree::rows
    int pivots, updates;        // unknowns of both kinds
    int parent;                 // -1 for a root
};

struct AssemblyTree {
    std::vector<int> order;    // the vertex at each place of the elimination
    std::vector<Front> fronts; // children before parents, whole subtrees together
    std::vector<int> rows;     // places in the order, ascending within a front
};

// Symbolic factorisation of a graph whose vertices stand for blocks of unknowns (of these widths). The tree's
// order has the same fill as the given one, but for what fronts gain by more zeros.
AssemblyTree assembly_tree(const Graph& graph, const std::vector<int>& order, const std::vector<int>& widths);

// Time of the numeric factorisation of a front, about [ns].
double time_of_front(double pivots, double updates);

} // namespace cholesky
