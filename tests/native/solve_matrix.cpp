// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Solves a linear system that comes on stdin as plain numbers, for the tests in Python:
//
//   int32   unknowns, entries, blocks, threads
//   int32   starts (unknowns + 1), rows (entries), block_of_unknown (unknowns)
//   double  values (entries), diagonal (unknowns), right-hand side (unknowns), points (blocks, 2)
//
// Writes an int32, 0 solved, 1 not positive definite, 2 no such pattern, and after 0 the solution.
#include <cstdint>
#include <cstdio>
#include <stdexcept>

#include "cholesky/cholesky.h"

namespace {

template <typename Number>
std::vector<Number> numbers(std::size_t count) {
    std::vector<Number> result(count);
    if (std::fread(result.data(), sizeof(Number), count, stdin) != count)
        throw std::runtime_error("the input ends early");
    return result;
}

int write(std::int32_t outcome, const std::vector<double>& solution) {
    std::fwrite(&outcome, sizeof outcome, 1, stdout);
    if (!solution.empty())
        std::fwrite(solution.data(), sizeof(double), solution.size(), stdout);
    return 0;
}

} // namespace

int main() {
    const std::vector<std::int32_t> sizes = numbers<std::int32_t>(4);
    const std::size_t unknowns = sizes[0], entries = sizes[1], count = sizes[2];
    cholesky::Pattern lower{numbers<std::int32_t>(unknowns + 1), numbers<std::int32_t>(entries)};
    cholesky::Blocks blocks{numbers<std::int32_t>(unknowns), {}};
    const std::vector<double> values = numbers<double>(entries), diagonal = numbers<double>(unknowns);
    std::vector<double> right_hand_side = numbers<double>(unknowns);
    const std::vector<double> points = numbers<double>(2 * count);
    for (std::size_t k = 0; k < count; ++k)
        blocks.points.push_back({points[2 * k], points[2 * k + 1]});
    try {
        cholesky::Factorisation factorisation(lower, blocks, sizes[3]);
        if (!factorisation.factorise(values.data(), diagonal.data()))
            return write(1, {});
        factorisation.solve(right_hand_side.data());
        return write(0, right_hand_side);
    } catch (const std::invalid_argument&) {
        return write(2, {});
    }
}
