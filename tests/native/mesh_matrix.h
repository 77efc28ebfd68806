// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Random matrices with the pattern of a film's stiffness, for the tests of the factorisation.
#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "cholesky/cholesky.h"

// The same numbers with every compiler, unlike the distributions of the standard library.
class Random {
public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double number() { return static_cast<double>(engine_()) / 4294967296.0 - 0.5; }
    bool one_in(unsigned count) { return engine_() % count == 0; }

private:
    std::mt19937 engine_;
};

using LowerTriangle = Eigen::SparseMatrix<double>;

inline cholesky::Pattern pattern_of(const LowerTriangle& lower) {
    return {{lower.outerIndexPtr(), lower.outerIndexPtr() + lower.cols() + 1},
            {lower.innerIndexPtr(), lower.innerIndexPtr() + lower.nonZeros()}};
}

struct MeshMatrix {
    cholesky::Blocks blocks;
    LowerTriangle lower;

    cholesky::Pattern pattern() const { return pattern_of(lower); }

    Eigen::MatrixXd dense() const { return Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>(); }
};

// Vertices in rows, where inside allows one, each with up to five unknowns: some are held.
struct Lattice {
    int rows, columns;
    std::vector<std::array<int, 5>> number; // of the unknowns of each vertex, -1 where held
    std::vector<int> vertex;                // at each place, -1 where there is none
    cholesky::Blocks blocks;

    Lattice(int row_count, int column_count, Random& random,
            const std::function<bool(double, double)>& inside)
        : rows(row_count), columns(column_count), vertex(static_cast<size_t>(rows) * columns, -1) {
        for (int i = 0; i < rows; ++i) {
            for (int j = 0; j < columns; ++j) {
                const double x = (j + 0.5 * (i % 2)) / columns, y = 0.866 * i / columns;
                if (inside(x, y)) {
                    vertex[i * columns + j] = static_cast<int>(number.size());
                    add_vertex(random);
                    blocks.points.push_back({x + 0.1 * random.number() / columns, y});
                }
            }
        }
    }

    void add_vertex(Random& random) {
        number.push_back({-1, -1, -1, -1, -1});
        const bool all_held = random.one_in(40);
        for (int& unknown : number.back()) {
            if (all_held || random.one_in(12))
                continue;
            unknown = static_cast<int>(blocks.block_of_unknown.size());
            blocks.block_of_unknown.push_back(static_cast<int>(number.size()) - 1);
        }
    }

    int at(int i, int j) const { return i < rows && j >= 0 && j < columns ? vertex[i * columns + j] : -1; }
};

using Entries = std::vector<Eigen::Triplet<double>>;

inline void add_random_square(const std::vector<int>& unknowns, Random& random, Entries& entries) {
    const int size = static_cast<int>(unknowns.size());
    const Eigen::MatrixXd root = Eigen::MatrixXd::NullaryExpr(size, size, [&] { return random.number(); });
    const Eigen::MatrixXd square = root * root.transpose();
    for (int a = 0; a < size; ++a) {
        for (int b = 0; b < size; ++b) {
            if (unknowns[a] >= unknowns[b] && unknowns[b] >= 0)
                entries.emplace_back(unknowns[a], unknowns[b], square(a, b));
        }
    }
}

// Sums of random squares over the triangles of a lattice; vertices two apart along the first row hold each
// other in two directions, as a seam does.
inline MeshMatrix mesh_matrix(int rows, int columns, unsigned seed,
                              const std::function<bool(double, double)>& inside) {
    Random random(seed);
    const Lattice lattice(rows, columns, random, inside);
    const auto& number = lattice.number;
    const auto at = [&](int i, int j) { return lattice.at(i, j); };
    Entries entries;
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < columns; ++j) {
            const int shift = i % 2;
            for (const auto& corners :
                 {std::array<int, 3>{at(i, j), at(i, j + 1), at(i + 1, j + shift)},
                  std::array<int, 3>{at(i, j), at(i + 1, j + shift - 1), at(i + 1, j + shift)}}) {
                if (*std::min_element(corners.begin(), corners.end()) < 0)
                    continue;
                std::vector<int> unknowns;
                for (int corner : corners)
                    unknowns.insert(unknowns.end(), number[corner].begin(), number[corner].end());
                add_random_square(unknowns, random, entries);
            }
            if (i == 0 && at(0, j) >= 0 && at(0, j + 2) >= 0) {
                const auto &near = number[at(0, j)], &far = number[at(0, j + 2)];
                add_random_square({near[0], near[1], far[0], far[1]}, random, entries);
            }
        }
    }
    const int count = static_cast<int>(lattice.blocks.block_of_unknown.size());
    for (int k = 0; k < count; ++k)
        entries.emplace_back(k, k, 0.1);
    MeshMatrix result{lattice.blocks, LowerTriangle(count, count)};
    result.lower.setFromTriplets(entries.begin(), entries.end());
    return result;
}

inline bool everywhere(double, double) {
    return true;
}
inline bool in_disc(double x, double y) {
    return std::hypot(x - 0.5, y - 0.45) < 0.42;
}
// Two parts that do not touch, one of them a ring.
inline bool in_parts(double x, double y) {
    const double r = std::hypot(x - 0.3, y - 0.4);
    return (r < 0.28 && r > 0.1) || x > 0.7;
}
