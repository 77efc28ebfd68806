// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "separator.h"

namespace cholesky {

// The vertices of a mesh's graph in an order of elimination with little fill: nested dissection (George
// 1973), small parts by minimum degree. points (one a vertex) is where the graph is drawn.
std::vector<int> nested_dissection(const Graph& graph, const std::vector<Point>& points);

} // namespace cholesky
