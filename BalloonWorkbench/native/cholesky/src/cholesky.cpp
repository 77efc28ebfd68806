// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cholesky/cholesky.h"

#include <algorithm>
#include <stdexcept>

#include "multifrontal.h"

namespace cholesky {
namespace {

// Whether the unknowns' blocks ascend and exist, and each column holds its diagonal, then rows that ascend.
bool is_valid(const Pattern& lower, const Blocks& blocks) {
    const std::vector<int>& block = blocks.block_of_unknown;
    const int count = static_cast<int>(block.size());
    if (lower.columns() != count || lower.starts[0] != 0
        || lower.starts[count] != static_cast<int>(lower.rows.size())
        || !std::is_sorted(block.begin(), block.end())
        || (count > 0 && (block[0] < 0 || block[count - 1] >= static_cast<int>(blocks.points.size()))))
        return false;
    for (int column = 0; column < count; ++column) {
        const int begin = lower.starts[column], end = lower.starts[column + 1];
        if (begin >= end || end > lower.starts[count] || lower.rows[begin] != column
            || lower.rows[end - 1] >= count)
            return false;
        for (int k = begin + 1; k < end; ++k) {
            if (lower.rows[k] <= lower.rows[k - 1])
                return false;
        }
    }
    return true;
}

} // namespace

int default_threads() {
    return ThreadPool::default_count();
}

Factorisation::Factorisation(Pattern lower, const Blocks& blocks, int threads) {
    if (!is_valid(lower, blocks))
        throw std::invalid_argument("no pattern of a lower triangle in blocks");
    implementation_ = std::make_unique<Multifrontal>(std::move(lower), blocks, threads);
}

Factorisation::~Factorisation() = default;

bool Factorisation::factorise(const double* values, const double* diagonal) {
    return implementation_->run(values, diagonal, nullptr);
}

void Factorisation::solve(double* right_hand_side) {
    implementation_->run(nullptr, nullptr, right_hand_side);
}

void Factorisation::solve(double* right_hand_sides, int count) {
    implementation_->solve(right_hand_sides, count);
}

bool Factorisation::factorise_and_solve(const double* values, const double* diagonal,
                                        double* right_hand_side) {
    return implementation_->run(values, diagonal, right_hand_side);
}

void Factorisation::set_interrupt(std::function<bool()> may_go_on) {
    implementation_->set_interrupt(std::move(may_go_on));
}

bool Factorisation::interrupted() const {
    return implementation_->interrupted();
}

size_t Factorisation::factor_entries() const {
    return implementation_->factor_entries();
}

size_t Factorisation::bytes() const {
    return implementation_->bytes();
}

} // namespace cholesky
