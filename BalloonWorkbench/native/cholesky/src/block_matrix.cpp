// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cholesky/block_matrix.h"

#include <algorithm>

namespace cholesky {
namespace {

// The joined blocks behind each, each once, ascending.
Pattern blocks_behind(int blocks, const std::vector<std::pair<int, int>>& joined) {
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
    Pattern behind;
    for (int block = 0; block < blocks; ++block) {
        const auto begin = all.begin() + first[block], end = all.begin() + first[block + 1];
        std::sort(begin, end);
        behind.rows.insert(behind.rows.end(), begin, std::unique(begin, end));
        behind.starts.push_back(static_cast<int>(behind.rows.size()));
    }
    behind.rows.shrink_to_fit();
    return behind;
}

} // namespace

BlockMatrix::BlockMatrix(const std::vector<int>& block_of_unknown, int blocks,
                         const std::vector<std::pair<int, int>>& joined)
    : block_of_unknown_(block_of_unknown), first_unknown_(blocks + 1, 0),
      behind_(blocks_behind(blocks, joined)) {
    for (int block : block_of_unknown)
        ++first_unknown_[block + 1];
    for (int block = 0; block < blocks; ++block)
        first_unknown_[block + 1] += first_unknown_[block];
    int count = 0;
    for (int block = 0; block < blocks; ++block) {
        int length = width(block);
        for (int k = behind_.starts[block]; k < behind_.starts[block + 1]; ++k)
            length += width(behind_.rows[k]);
        begin_.push_back(count);
        stride_.push_back(length);
        count += offset(block, 0, width(block)) + width(block);
    }
    values_.resize(count);
}

Pattern BlockMatrix::pattern() const {
    Pattern pattern;
    pattern.starts.reserve(block_of_unknown_.size() + 1);
    pattern.rows.reserve(values_.size());
    const auto add = [&](int first, int last) {
        for (int row = first; row < last; ++row)
            pattern.rows.push_back(row);
    };
    for (int column = 0; column < first_unknown_.back(); ++column) {
        const int block = block_of_unknown_[column];
        add(column, first_unknown_[block + 1]);
        for (int k = behind_.starts[block]; k < behind_.starts[block + 1]; ++k)
            add(first_unknown_[behind_.rows[k]], first_unknown_[behind_.rows[k] + 1]);
        pattern.starts.push_back(static_cast<int>(pattern.rows.size()));
    }
    return pattern;
}

int BlockMatrix::begin(int row_block, int column_block) const {
    int place = begin_[column_block];
    if (row_block != column_block) {
        place += width(column_block);
        for (const int* other = &behind_.rows[behind_.starts[column_block]]; *other != row_block; ++other)
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

} // namespace cholesky
