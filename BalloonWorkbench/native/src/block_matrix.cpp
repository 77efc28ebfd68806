// SPDX-License-Identifier: LGPL-2.1-or-later
#include "block_matrix.h"

#include <algorithm>

namespace film {
namespace {

// The joined blocks behind each, each once, ascending.
Graph graph_behind(int blocks, const std::vector<std::pair<int, int>>& joined) {
    std::vector<int> first(blocks + 1, 0);
    for (const auto& [a, b] : joined)
        first[std::min(a, b) + 1] += a != b;
    for (int block = 0; block < blocks; ++block)
        first[block + 1] += first[block];
    std::vector<int> all(first.back()), next(first.begin(), first.end() - 1);
    for (const auto& [a, b] : joined) {
        if (a != b)
            all[next[std::min(a, b)]++] = std::max(a, b);
    }
    Graph behind;
    for (int block = 0; block < blocks; ++block) {
        const auto begin = all.begin() + first[block], end = all.begin() + first[block + 1];
        std::sort(begin, end);
        behind.neighbour.insert(behind.neighbour.end(), begin, std::unique(begin, end));
        behind.first.push_back(static_cast<int>(behind.neighbour.size()));
    }
    behind.neighbour.shrink_to_fit();
    return behind;
}

} // namespace

BlockMatrix::BlockMatrix(const std::vector<int>& block_of_unknown, int blocks,
                         const std::vector<std::pair<int, int>>& joined)
    : block_of_unknown_(block_of_unknown), first_unknown_(blocks + 1, 0),
      behind_(graph_behind(blocks, joined)) {
    for (int block : block_of_unknown)
        ++first_unknown_[block + 1];
    for (int block = 0; block < blocks; ++block)
        first_unknown_[block + 1] += first_unknown_[block];
    int count = 0;
    for (int block = 0; block < blocks; ++block) {
        int length = width(block);
        for (int other : Neighbours{behind_, block})
            length += width(other);
        begin_.push_back(count);
        stride_.push_back(length);
        count += offset(block, 0, width(block)) + width(block);
    }
    values_.resize(count);
}

SymmetricMatrix BlockMatrix::pattern() const {
    const int count = first_unknown_.back();
    SymmetricMatrix pattern(count, count);
    pattern.resizeNonZeros(static_cast<Eigen::Index>(values_.size()));
    int* const starts = pattern.outerIndexPtr();
    int* row = pattern.innerIndexPtr();
    for (int column = 0; column < count; ++column) {
        const int block = block_of_unknown_[column];
        starts[column] = static_cast<int>(row - pattern.innerIndexPtr());
        for (int own = column; own < first_unknown_[block + 1]; ++own)
            *row++ = own;
        for (int other : Neighbours{behind_, block}) {
            for (int unknown = first_unknown_[other]; unknown < first_unknown_[other + 1]; ++unknown)
                *row++ = unknown;
        }
    }
    starts[count] = static_cast<int>(values_.size());
    return pattern;
}

int BlockMatrix::begin(int row_block, int column_block) const {
    int place = begin_[column_block];
    if (row_block != column_block) {
        place += width(column_block);
        for (const int* other = behind_.begin(column_block); *other != row_block; ++other)
            place += width(*other);
    }
    return place;
}

void BlockMatrix::add(int row, int column, double value) {
    if (row < column)
        std::swap(row, column);
    const int a = block_of_unknown_[row], b = block_of_unknown_[column];
    values_[begin(a, b) + offset(b, row - first_unknown_[a], column - first_unknown_[b])] += value;
}

} // namespace film
