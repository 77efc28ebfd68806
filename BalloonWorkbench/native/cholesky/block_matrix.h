// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <utility>

#include "cholesky/cholesky.h"

namespace cholesky {

// Lower triangle of a symmetric sparse matrix whose unknowns come in blocks: where two blocks are joined, all
// their unknowns are. Column by column, each with the rest of its own block and then the blocks behind it.
class BlockMatrix {
public:
    // joined: pairs of blocks, in any order, as often as it happens.
    BlockMatrix(const std::vector<int>& block_of_unknown, int blocks,
                const std::vector<std::pair<int, int>>& joined);

    // Of the numbers in the order of values().
    Pattern pattern() const;

    const std::vector<double>& values() const { return values_; }
    void clear() { std::fill(values_.begin(), values_.end(), 0.0); }

    // Where the numbers begin that a block has in the columns of another, or of itself: that in its row i and
    // the other's column j follows by offset(block, i, j).
    int begin(int row_block, int column_block) const;
    int offset(int column_block, int i, int j) const {
        return i + j * stride_[column_block] - j * (j + 1) / 2;
    }
    double* at(int place) { return &values_[place]; }

    // Adds to one number, whichever of the two unknowns comes first.
    void add(int row, int column, double value);

private:
    int width(int block) const { return first_unknown_[block + 1] - first_unknown_[block]; }

    const std::vector<int>& block_of_unknown_;
    std::vector<int> first_unknown_; // of each block
    Pattern behind_;                 // the joined blocks behind each, ascending
    std::vector<int> begin_;         // of each block's columns
    std::vector<int> stride_;        // length of each block's first column
    std::vector<double> values_;
};

} // namespace cholesky
