// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "cholesky/cholesky.h"
#include "graph.h"

namespace cholesky {

enum class Part : signed char { left, right, separator };

// Splits a graph drawn in the plane in two parts with no edge between them, by the straight cut that promises
// the least work for a nested dissection (as Heath and Raghavan 1995, in more directions). outside marks the
// vertices with neighbours beyond this graph.
std::vector<Part> bisect(const Graph& graph, const std::vector<Point>& points,
                         const std::vector<char>& outside);

} // namespace cholesky
