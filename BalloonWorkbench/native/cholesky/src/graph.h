// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

namespace cholesky {

// Undirected graph without loops: the neighbours of v are neighbour[first[v]] .. neighbour[first[v + 1] - 1].
struct Graph {
    std::vector<int> first{0};
    std::vector<int> neighbour;

    int size() const { return static_cast<int>(first.size()) - 1; }
    const int* begin(int v) const { return neighbour.data() + first[v]; }
    const int* end(int v) const { return neighbour.data() + first[v + 1]; }
};

// The range of neighbours of a vertex, for loops.
struct Neighbours {
    const Graph& graph;
    int vertex;
    const int* begin() const { return graph.begin(vertex); }
    const int* end() const { return graph.end(vertex); }
};

} // namespace cholesky
