// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>

#include "front_kernels.h"
#include "simd/vec4.h"

namespace cholesky {

using namespace simd;

// Both substitutions with the factor of a front.

template <int R>
SIMD_INLINE void forward_strip(const FrontShape& shape, int row, int last, const double* factor,
                               const double* pivots, double* values) {
    const double* rows[R];
    Vec4 sum[R];
    for (int r = 0; r < R; ++r) {
        rows[r] = factor + shape.row_group(row + r);
        load(sum[r], values + 4 * r);
    }
    for (int k = 0; k < last; ++k) {
        SIMD_UNROLL
        for (int r = 0; r < R; ++r) {
            Vec4 a;
            load(a, rows[r] + 4 * k);
            sum[r] = sum[r] - a * pivots[k];
        }
    }
    for (int r = 0; r < R; ++r)
        store(sum[r], values + 4 * r);
}

SIMD_INLINE void forward_body(const FrontShape& shape, const double* factor, double* pivots,
                              double* updates) {
    for (int row = 0; row < shape.pivot_groups; ++row) {
        double* const x = pivots + 4 * row;
        forward_strip<1>(shape, row, 4 * row, factor, pivots, x);
        const double* const diagonal = factor + shape.row_group(row) + 16 * row;
        for (int c = 0; c < 4; ++c) {
            for (int j = 0; j < c; ++j)
                x[c] -= diagonal[4 * j + c] * x[j];
            x[c] *= diagonal[5 * c];
        }
    }
    int row = shape.pivot_groups;
    for (; row + 4 <= shape.groups(); row += 4, updates += 16)
        forward_strip<4>(shape, row, shape.columns(), factor, pivots, updates);
    for (; row < shape.groups(); ++row, updates += 4)
        forward_strip<1>(shape, row, shape.columns(), factor, pivots, updates);
}

// sums[k] += column k of the factor in R groups of rows, times the values of these rows
template <int R>
SIMD_INLINE void backward_strip(const FrontShape& shape, int row, int last, const double* factor,
                                const double* values, double* sums) {
    const double* rows[R];
    Vec4 x[R];
    for (int r = 0; r < R; ++r) {
        rows[r] = factor + shape.row_group(row + r);
        load(x[r], values + 4 * r);
    }
    for (int k = 0; k < 4 * last; k += 4) {
        Vec4 sum;
        load(sum, sums + k);
        SIMD_UNROLL
        for (int r = 0; r < R; ++r) {
            Vec4 a;
            load(a, rows[r] + k);
            sum = sum + a * x[r];
        }
        store(sum, sums + k);
    }
}

SIMD_INLINE void backward_body(const FrontShape& shape, const double* factor, double* pivots,
                               const double* updates, double* sums) {
    std::fill(sums, sums + 4 * shape.columns(), 0.0);
    int row = shape.pivot_groups;
    for (; row + 4 <= shape.groups(); row += 4, updates += 16)
        backward_strip<4>(shape, row, shape.columns(), factor, updates, sums);
    for (; row < shape.groups(); ++row, updates += 4)
        backward_strip<1>(shape, row, shape.columns(), factor, updates, sums);
    for (row = shape.pivot_groups - 1; row >= 0; --row) {
        double* const x = pivots + 4 * row;
        const double* const diagonal = factor + shape.row_group(row) + 16 * row;
        for (int c = 3; c >= 0; --c) {
            Vec4 sum;
            load(sum, sums + 16 * row + 4 * c);
            x[c] -= sum_of(sum);
            for (int r = c + 1; r < 4; ++r)
                x[c] -= diagonal[4 * c + r] * x[r];
            x[c] *= diagonal[5 * c];
        }
        backward_strip<1>(shape, row, 4 * row, factor, x, sums);
    }
}

} // namespace cholesky
