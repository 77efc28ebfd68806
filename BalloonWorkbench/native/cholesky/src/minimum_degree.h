// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "graph.h"

namespace cholesky {

// Order of elimination of the vertices 0 .. inner - 1 of a small graph by exact minimum degree (Tinney and
// Walker 1967). The others are eliminated later: they count in the degrees; only their edges to inner
// vertices need be there.
std::vector<int> minimum_degree(const Graph& graph, int inner);

} // namespace cholesky
