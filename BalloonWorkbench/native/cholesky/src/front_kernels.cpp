// SPDX-License-Identifier: LGPL-2.1-or-later
#include "front_kernels.h"

#include <algorithm>
#include <cmath>

#include "front_solves.h"
#include "simd/vec4.h"

namespace cholesky {
namespace {

constexpr int kStrips = 4;

// Products of R groups of rows with one group of columns, over the columns first .. last - 1 of the factor.
template <int R>
SIMD_INLINE void products(double* const (&rows)[R], const double* columns, int first, int last,
                          Vec4 (&sum)[R][4]) {
    SIMD_UNROLL
    for (int r = 0; r < R; ++r) {
        SIMD_UNROLL
        for (int c = 0; c < 4; ++c)
            sum[r][c] = Vec4{};
    }
    for (int k = 4 * first; k < 4 * last; k += 4) {
        Vec4 a[R];
        SIMD_UNROLL
        for (int r = 0; r < R; ++r)
            load(a[r], rows[r] + k);
        SIMD_UNROLL
        for (int c = 0; c < 4; ++c) {
            SIMD_UNROLL
            for (int r = 0; r < R; ++r)
                sum[r][c] = sum[r][c] + a[r] * columns[k + c];
        }
    }
}

// One group of columns of the factor in R groups of rows; columns is the group of rows of these pivots.
template <int R>
SIMD_INLINE void solve_tile(const double* tile, int height, const double* columns, int first, int column,
                            double* const (&rows)[R]) {
    Vec4 x[R][4];
    products<R>(rows, columns, first, column, x);
    const double* const diagonal = columns + 4 * column;
    SIMD_UNROLL
    for (int r = 0; r < R; ++r) {
        SIMD_UNROLL
        for (int c = 0; c < 4; ++c) {
            Vec4 value;
            load(value, tile + 4 * r + static_cast<size_t>(c) * height);
            value = value - x[r][c];
            SIMD_UNROLL
            for (int j = 0; j < c; ++j)
                value = value - x[r][j] * diagonal[4 * j + c];
            x[r][c] = value * diagonal[5 * c];
            store(x[r][c], rows[r] + 4 * (column + c));
        }
    }
}

// The diagonal block of a group of pivots.
SIMD_INLINE bool factor_tile(const double* tile, int height, int first, int column, double* row) {
    Vec4 sum[1][4];
    double* const rows[1] = {row};
    products<1>(rows, row, first, column, sum);
    double* const diagonal = row + 4 * column;
    for (int c = 0; c < 4; ++c) {
        Vec4 value;
        load(value, tile + static_cast<size_t>(c) * height);
        value = value - sum[0][c];
        for (int j = 0; j < c; ++j) {
            Vec4 left;
            load(left, diagonal + 4 * j);
            value = value - left * diagonal[4 * j + c];
        }
        if (!(value[c] > 0.0))
            return false;
        const double inverse = 1.0 / std::sqrt(value[c]);
        value = value * inverse;
        value[c] = inverse;
        store(value, diagonal + 4 * c);
    }
    return true;
}

// Columns of the factor in a few strips of R groups of rows, left-looking from the group first on. One strip
// after the other in each column: the processor has the products of one to do while it waits for the other.
template <int R>
SIMD_INLINE void solve_strips(const FrontShape& shape, int first, Groups columns, int row, int strips,
                              const double* panel, double* factor) {
    const int height = shape.height();
    for (int column = columns.first; column < columns.last; ++column) {
        const double* const pivots = factor + shape.row_group(column);
        const double* tile = panel + 4 * row + static_cast<size_t>(4 * column) * height;
        for (int strip = 0; strip < strips; ++strip, tile += 4 * R) {
            double* rows[R];
            SIMD_UNROLL
            for (int r = 0; r < R; ++r)
                rows[r] = factor + shape.row_group(row + R * strip + r);
            solve_tile<R>(tile, height, pivots, 4 * first, 4 * column, rows);
        }
    }
}

template <int Wide>
SIMD_INLINE void solve_all_rows(const FrontShape& shape, int first, Groups columns, Groups rows,
                                const double* panel, double* factor) {
    int row = rows.first;
    while (row + Wide <= rows.last) {
        const int strips = std::min(kStrips, (rows.last - row) / Wide);
        solve_strips<Wide>(shape, first, columns, row, strips, panel, factor);
        row += Wide * strips;
    }
    if (Wide > 2 && row + 2 <= rows.last) {
        solve_strips<2>(shape, first, columns, row, 1, panel, factor);
        row += 2;
    }
    if (Wide > 1 && row < rows.last)
        solve_strips<1>(shape, first, columns, row, 1, panel, factor);
}

template <int Wide>
SIMD_INLINE bool factor_block_body(const FrontShape& shape, Groups block, const double* panel,
                                   double* factor) {
    const int height = shape.height();
    for (int first = block.first; first < block.last; first += Wide) {
        const int last = std::min(first + Wide, block.last);
        for (int row = first; row < last; ++row) {
            solve_strips<1>(shape, block.first, {first, row}, row, 1, panel, factor);
            if (!factor_tile(panel + 4 * row + static_cast<size_t>(4 * row) * height, height, 4 * block.first,
                             4 * row, factor + shape.row_group(row)))
                return false;
        }
        solve_all_rows<Wide>(shape, block.first, {first, last}, {last, block.last}, panel, factor);
    }
    return true;
}

template <int R>
SIMD_INLINE void multiply_strip(const FrontShape& shape, Groups block, Groups columns, int row,
                                bool overwrite, double* factor, double* target, int height) {
    double* rows[R];
    for (int r = 0; r < R; ++r)
        rows[r] = factor + shape.row_group(row + r);
    const int last = std::min(columns.last, row + R);
    for (int column = columns.first; column < last; ++column, target += 4 * static_cast<size_t>(height)) {
        Vec4 sum[R][4];
        products<R>(rows, factor + shape.row_group(column), 4 * block.first, 4 * block.last, sum);
        SIMD_UNROLL
        for (int c = 0; c < 4; ++c) {
            double* const to = target + static_cast<size_t>(c) * height;
            SIMD_UNROLL
            for (int r = 0; r < R; ++r) {
                Vec4 value{};
                if (!overwrite)
                    load(value, to + 4 * r);
                store(value - sum[r][c], to + 4 * r);
            }
        }
    }
}

template <int Wide>
SIMD_INLINE void multiply_body(const FrontShape& shape, Groups block, Groups columns, Groups rows,
                               bool overwrite, double* factor, int origin, double* target, int height) {
    double* const corner = target + static_cast<size_t>(4 * (columns.first - origin)) * height;
    int row = rows.first;
    for (; row + Wide <= rows.last; row += Wide)
        multiply_strip<Wide>(shape, block, columns, row, overwrite, factor, corner + 4 * (row - origin),
                             height);
    if (Wide > 2 && row + 2 <= rows.last) {
        multiply_strip<2>(shape, block, columns, row, overwrite, factor, corner + 4 * (row - origin), height);
        row += 2;
    }
    if (Wide > 1 && row < rows.last)
        multiply_strip<1>(shape, block, columns, row, overwrite, factor, corner + 4 * (row - origin), height);
}

SIMD_INLINE void add_body(const double* source, int source_height, int rows, int columns, bool lower,
                          double* target, int target_height) {
    for (int column = 0; column < columns; ++column) {
        int row = lower ? column : 0;
        for (; row + 4 <= rows; row += 4) {
            Vec4 a, b;
            load(a, source + row);
            load(b, target + row);
            store(b + a, target + row);
        }
        for (; row < rows; ++row)
            target[row] += source[row];
        source += source_height;
        target += target_height;
    }
}

// The same functions compiled for one instruction set. WIDE groups of rows times four columns of sums stay in
// its registers.
// NOLINTBEGIN(bugprone-macro-parentheses): an attribute cannot stand in parentheses
#define CHOLESKY_KERNELS(NAME, TARGET, WIDE)                                                                 \
    TARGET bool factor_block_##NAME(const FrontShape& shape, Groups block, const double* panel,              \
                                    double* factor) {                                                        \
        return factor_block_body<WIDE>(shape, block, panel, factor);                                         \
    }                                                                                                        \
    TARGET void solve_rows_##NAME(const FrontShape& shape, Groups block, Groups rows, const double* panel,   \
                                  double* factor) {                                                          \
        solve_all_rows<WIDE>(shape, block.first, block, rows, panel, factor);                                \
    }                                                                                                        \
    TARGET void multiply_##NAME(const FrontShape& shape, Groups block, Groups columns, Groups rows,          \
                                bool overwrite, double* factor, int origin, double* target, int height) {    \
        multiply_body<WIDE>(shape, block, columns, rows, overwrite, factor, origin, target, height);         \
    }                                                                                                        \
    TARGET void add_##NAME(const double* source, int source_height, int rows, int columns, bool lower,       \
                           double* target, int target_height) {                                              \
        add_body(source, source_height, rows, columns, lower, target, target_height);                        \
    }                                                                                                        \
    TARGET void forward_##NAME(const FrontShape& shape, const double* factor, double* pivots,                \
                               double* updates) {                                                            \
        forward_body(shape, factor, pivots, updates);                                                        \
    }                                                                                                        \
    TARGET void backward_##NAME(const FrontShape& shape, const double* factor, double* pivots,               \
                                const double* updates, double* scratch) {                                    \
        backward_body(shape, factor, pivots, updates, scratch);                                              \
    }                                                                                                        \
    constexpr FrontKernels NAME{factor_block_##NAME, solve_rows_##NAME, multiply_##NAME,                     \
                                add_##NAME,          forward_##NAME,    backward_##NAME};
// NOLINTEND(bugprone-macro-parentheses)

#if defined(__aarch64__) || defined(_M_ARM64)
CHOLESKY_KERNELS(portable, , 2)
#else
CHOLESKY_KERNELS(portable, , 1)
#endif
#ifdef SIMD_HAS_AVX2
CHOLESKY_KERNELS(avx2, SIMD_AVX2, 3)
#endif

} // namespace

const FrontKernels& front_kernels() {
#ifdef SIMD_HAS_AVX2
    if (has_avx2())
        return avx2;
#endif
    return portable;
}

const FrontKernels& portable_front_kernels() {
    return portable;
}

} // namespace cholesky
