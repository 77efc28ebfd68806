// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The sparse factorisation against Eigen's dense one. Prints what fails; exits 0 when all is well.
#include "cholesky/cholesky.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <new>

#include "cholesky/src/front_kernels.h"
#include "mesh_matrix.h"

static std::atomic<long> allocations{0};

[[gnu::noinline]] void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size ? size : 1))
        return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace {

using cholesky::Factorisation;
using Eigen::MatrixXd;
using Eigen::VectorXd;

int failures = 0;

void check(bool passed, const char* what, const char* where) {
    if (!passed) {
        std::printf("failed: %s (%s)\n", what, where);
        ++failures;
    }
}

VectorXd right_hand_side(Eigen::Index count) {
    return VectorXd::NullaryExpr(count,
                                 [](Eigen::Index k) { return std::sin(0.37 * static_cast<double>(k)); });
}

VectorXd solved(Factorisation& cholesky, const VectorXd& b) {
    VectorXd x = b;
    cholesky.solve(x.data());
    return x;
}

void agrees_with_dense(const MeshMatrix& matrix, const char* name) {
    const VectorXd b = right_hand_side(matrix.lower.cols());
    const VectorXd diagonal = 0.01 * (b.array() + 2.0);
    Factorisation cholesky(matrix.pattern(), matrix.blocks, 1);
    for (const bool shifted : {false, true}) {
        MatrixXd full = matrix.dense();
        if (shifted)
            full.diagonal() += diagonal;
        const VectorXd expected = full.llt().solve(b);
        check(cholesky.factorise(matrix.lower.valuePtr(), shifted ? diagonal.data() : nullptr), "definite",
              name);
        const VectorXd x = solved(cholesky, b);
        check((x - expected).norm() <= 1e-10 * expected.norm(), "solution", name);
        MatrixXd many(b.size(), 37);
        for (Eigen::Index k = 0; k < many.cols(); ++k)
            many.col(k) = (1.0 + k) * b;
        cholesky.solve(many.data(), static_cast<int>(many.cols()));
        for (Eigen::Index k = 0; k < many.cols(); ++k)
            check((many.col(k) - (1.0 + k) * x).norm() <= 1e-12 * many.col(k).norm(), "many", name);
        check((full * x - b).norm() <= 1e-12 * (full.norm() * x.norm() + b.norm()), "residual", name);
    }
}

// One part in a million on either side of the smallest eigenvalue.
void tells_definite_from_not(const MeshMatrix& matrix, const char* name) {
    const double smallest = Eigen::SelfAdjointEigenSolver<MatrixXd>(matrix.dense()).eigenvalues()[0];
    Factorisation cholesky(matrix.pattern(), matrix.blocks, 1);
    const Eigen::Index count = matrix.lower.cols();
    const VectorXd below = VectorXd::Constant(count, -smallest * (1.0 - 1e-6));
    const VectorXd above = VectorXd::Constant(count, -smallest * (1.0 + 1e-6));
    VectorXd x = right_hand_side(count);
    check(!cholesky.factorise(matrix.lower.valuePtr(), above.data()), "indefinite", name);
    check(!cholesky.factorise_and_solve(matrix.lower.valuePtr(), above.data(), x.data()), "indefinite", name);
    check(x == right_hand_side(count), "right-hand side kept", name);
    check(cholesky.factorise(matrix.lower.valuePtr(), below.data()), "just definite", name);
    VectorXd undefined = VectorXd::Zero(count);
    undefined[count / 2] = std::nan("");
    check(!cholesky.factorise(matrix.lower.valuePtr(), undefined.data()), "not a number", name);
    check(cholesky.factorise(matrix.lower.valuePtr(), nullptr), "definite after all", name);
    check((matrix.dense() * solved(cholesky, x) - x).norm() < 1e-9, "solution after all", name);
}

// A pivot fails in a late front while other threads work.
void stops_on_every_thread(const MeshMatrix& matrix, const char* name) {
    Factorisation cholesky(matrix.pattern(), matrix.blocks, 3);
    const VectorXd b = right_hand_side(matrix.lower.cols());
    check(cholesky.factorise(matrix.lower.valuePtr(), nullptr), "definite", name);
    const VectorXd expected = solved(cholesky, b);
    for (Eigen::Index k = 7; k < b.size(); k += b.size() / 9) {
        VectorXd diagonal = VectorXd::Zero(b.size()), x = b;
        diagonal[k] = -100.0;
        check(!cholesky.factorise_and_solve(matrix.lower.valuePtr(), diagonal.data(), x.data()), "indefinite",
              name);
    }
    VectorXd x = b;
    check(cholesky.factorise_and_solve(matrix.lower.valuePtr(), nullptr, x.data()), "definite", name);
    check(x == expected, "same as before", name);
}

void same_on_any_number_of_threads(const MeshMatrix& matrix, const char* name) {
    const VectorXd b = right_hand_side(matrix.lower.cols());
    VectorXd first;
    for (const int threads : {1, 2, 3, 4}) {
        Factorisation cholesky(matrix.pattern(), matrix.blocks, threads);
        for (int again = 0; again < 5; ++again) {
            const long before = allocations;
            VectorXd x = b, y = b;
            const long vectors = allocations - before;
            check(cholesky.factorise(matrix.lower.valuePtr(), nullptr), "definite", name);
            cholesky.solve(x.data());
            check(cholesky.factorise_and_solve(matrix.lower.valuePtr(), nullptr, y.data()), "definite", name);
            check(allocations - before == vectors, "nothing allocated", name);
            check(x == y, "both at once", name);
            if (first.size() == 0) {
                const VectorXd residual = matrix.lower.selfadjointView<Eigen::Lower>() * x - b;
                check(residual.norm() < 1e-9, "residual", name);
                first = x;
            }
            check(x == first, "same on any number of threads", name);
        }
    }
}

// Where the points say nothing, only the speed may suffer.
void needs_no_good_points(MeshMatrix matrix, const char* name) {
    for (const double value : {0.25, std::nan(""), std::numeric_limits<double>::infinity(), 1e300}) {
        for (size_t k = 0; k < matrix.blocks.points.size(); ++k)
            matrix.blocks.points[k] = {value, k % 3 == 0 ? -value : value};
        agrees_with_dense(matrix, name);
    }
}

// Against the usual minimum degree ordering; larger fronts with some zeros are wanted, many are not.
void fills_little(const MeshMatrix& matrix, const char* name) {
    const Eigen::SimplicialLLT<LowerTriangle> reference(matrix.lower);
    const auto entries = static_cast<double>(reference.matrixL().nestedExpression().nonZeros());
    const Factorisation cholesky(matrix.pattern(), matrix.blocks, 1);
    check(static_cast<double>(cholesky.factor_entries()) < 1.4 * entries, "fill", name);
    check(static_cast<double>(cholesky.bytes()) < 2.0 * 8.0 * entries, "memory", name);
}

void takes_the_smallest(const char* name) {
    LowerTriangle one(1, 1), none(0, 0);
    one.insert(0, 0) = 4.0;
    one.makeCompressed();
    Factorisation cholesky(pattern_of(one), {{0}, {{0.0, 0.0}}}, 2);
    double x = 6.0;
    check(cholesky.factorise_and_solve(one.valuePtr(), nullptr, &x) && x == 1.5, "one unknown", name);
    Factorisation empty(pattern_of(none), {{}, {{0.0, 0.0}, {1.0, 0.0}}}, 2);
    check(empty.factorise(nullptr, nullptr), "no unknown", name);
    empty.solve(nullptr);
}

// The kernels of every processor and those of this one, front by front.
void kernels_agree(const char* name) {
    for (const auto& [pivots, updates] : {std::pair(1, 0), {3, 2}, {5, 40}, {20, 61}, {61, 20}, {130, 75}}) {
        const cholesky::FrontShape shape(pivots, updates);
        const int columns = shape.columns(), rest = shape.height() - columns;
        Random random(pivots);
        const MatrixXd root =
            MatrixXd::NullaryExpr(shape.height(), shape.height(), [&] { return random.number(); });
        MatrixXd panel = (root * root.transpose() + MatrixXd::Identity(shape.height(), shape.height()));
        const MatrixXd lower = panel.llt().matrixL();
        for (const cholesky::FrontKernels* kernels :
             {&cholesky::front_kernels(), &cholesky::portable_front_kernels()}) {
            std::vector<double> factor(shape.factor_size());
            MatrixXd update(rest, rest);
            const cholesky::Groups block{0, shape.pivot_groups}, below{shape.pivot_groups, shape.groups()};
            check(kernels->factor_block(shape, block, panel.data(), factor.data()), "definite", name);
            kernels->solve_rows(shape, block, below, panel.data(), factor.data());
            kernels->multiply(shape, block, below, below, true, factor.data(), shape.pivot_groups,
                              update.data(), rest);
            double worst = 0.0;
            for (int row = 0; row < shape.height(); ++row) {
                for (int column = 0; column < std::min(row + 1, columns); ++column) {
                    const double value = factor[shape.row_group(row / 4) + 4 * column + row % 4];
                    const double expected = row == column ? 1.0 / lower(row, row) : lower(row, column);
                    worst = std::max(worst, std::abs(value - expected));
                }
            }
            check(worst < 1e-11, "factor of a front", name);
            const MatrixXd left = lower.bottomLeftCorner(rest, columns);
            const MatrixXd difference = (update + left * left.transpose()).triangularView<Eigen::Lower>();
            check(difference.norm() < 1e-10, "update of a front", name);
        }
    }
}

} // namespace

int main() {
    const MeshMatrix strip = mesh_matrix(4, 12, 1, everywhere), disc = mesh_matrix(16, 16, 2, in_disc);
    const MeshMatrix parts = mesh_matrix(14, 18, 3, in_parts), large = mesh_matrix(44, 44, 4, in_disc);
    agrees_with_dense(strip, "strip");
    agrees_with_dense(disc, "disc");
    agrees_with_dense(parts, "parts");
    tells_definite_from_not(strip, "strip");
    tells_definite_from_not(mesh_matrix(9, 9, 5, in_disc), "small disc");
    same_on_any_number_of_threads(large, "large disc");
    stops_on_every_thread(large, "large disc");
    fills_little(large, "large disc");
    fills_little(mesh_matrix(70, 70, 7, in_parts), "large parts");
    needs_no_good_points(mesh_matrix(12, 12, 6, in_disc), "disc without points");
    takes_the_smallest("smallest");
    kernels_agree("kernels");
    return failures == 0 ? 0 : 1;
}
