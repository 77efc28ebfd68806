// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Sparse Cholesky factorisation A = L L^T of symmetric positive definite matrices that share a pattern, such
// as the tangents of a Newton iteration on a mesh.
//
// Ordering: nested dissection (George 1973) by straight cuts, small parts by minimum degree (Tinney and
// Walker 1967). Factorisation: multifrontal (Duff and Reid 1983) with relaxed supernodes (Ashcraft and Grimes
// 1989). Needs the C++ library and threads, nothing else. See also block_matrix.h, which assembles such a
// matrix.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace cholesky {

// Ascending row numbers, column by column: those of column c are rows[starts[c]] .. rows[starts[c + 1] - 1].
struct Pattern {
    std::vector<int> starts{0}, rows;

    int columns() const { return static_cast<int>(starts.size()) - 1; }
};

using Point = std::array<double, 2>;

// Unknowns in blocks, such as those of a vertex: numbers that follow each other, with much the same
// neighbours, at one point of the plane. Every unknown may be a block of its own; points that say nothing of
// the neighbours cost time and memory, but change no solution beyond rounding.
struct Blocks {
    std::vector<int> block_of_unknown; // ascending
    std::vector<Point> points;         // of each block; a block may be empty
};

class Multifrontal;

// As many threads as find work of their own on this machine.
int default_threads();

// Factorisations and solves allocate nothing. The result does not depend on the number of threads, to the
// last bit. For one caller at a time.
class Factorisation {
public:
    // The pattern of the lower triangle, with the diagonal first in each column. Throws std::invalid_argument
    // where pattern and blocks are no such thing.
    Factorisation(Pattern lower, const Blocks& blocks, int threads);
    ~Factorisation();
    Factorisation(const Factorisation&) = delete;
    Factorisation& operator=(const Factorisation&) = delete;

    // Factors the matrix with these values in its lower triangle, plus a diagonal one unless null; false when
    // it is not positive definite.
    bool factorise(const double* values, const double* diagonal);

    // Replaces the right-hand side by the solution, after a factorisation that succeeded.
    void solve(double* right_hand_side);

    // The same for many, one after the other in memory, on this thread; faster than each by itself.
    void solve(double* right_hand_sides, int count);

    // Both; faster, for one half of the solution is done while the factor is still in cache. Leaves the
    // right-hand side when the matrix is not positive definite.
    bool factorise_and_solve(const double* values, const double* diagonal, double* right_hand_side);

    // Calls a function, on the calling thread and now and then during a factorisation that takes long; where
    // it returns false, the factorisation stops and the matrix counts as not positive definite.
    void set_interrupt(std::function<bool()> may_go_on);
    bool interrupted() const; // in the last factorisation

    size_t factor_entries() const; // with the zeros that are stored
    size_t bytes() const;          // of all memory held

private:
    std::unique_ptr<Multifrontal> implementation_;
};

} // namespace cholesky
