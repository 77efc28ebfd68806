// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

namespace film {

using Point = std::array<double, 2>;

// Unknowns in blocks, such as those of a vertex: numbers that follow each other, with much the same
// neighbours, at one point of the plane.
struct Blocks {
    std::vector<int> block_of_unknown; // ascending
    std::vector<Point> points;         // of each block; a block may be empty
};

} // namespace film
