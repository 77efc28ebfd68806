// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

namespace cholesky {

// Dense Cholesky of a front, left-looking by blocks of pivots. All of it goes by groups of four rows and
// columns.
//
// The front is assembled by columns in a panel: first the pivots, padded to whole groups, then the updates,
// padded likewise. The factor is packed: each group of four rows is a run of columns of four numbers, as the
// kernels read it; rows of pivots end at their diagonal, which holds the reciprocals of the pivots.
constexpr int kGroup = 4;

struct FrontShape {
    int pivot_groups, update_groups;

    FrontShape(int pivots, int updates)
        : pivot_groups((pivots + kGroup - 1) / kGroup), update_groups((updates + kGroup - 1) / kGroup) {}

    int groups() const { return pivot_groups + update_groups; }
    int columns() const { return kGroup * pivot_groups; }
    int height() const { return kGroup * groups(); } // of the panel
    size_t panel_size() const { return size_t(height()) * columns(); }
    size_t update_size() const { return size_t(kGroup * update_groups) * (kGroup * update_groups); }
    size_t factor_size() const { return row_group(groups()); }
    // Where a group of rows begins in the factor.
    size_t row_group(int group) const {
        const size_t g = group, p = pivot_groups;
        return g <= p ? 8 * g * (g + 1) : 8 * p * (p + 1) + (g - p) * 16 * p;
    }
};

// Groups first .. last - 1.
struct Groups {
    int first, last;
};

struct FrontKernels {
    // Factors the pivots of a block in its own rows, left-looking from its first column on; false when one is
    // not positive.
    bool (*factor_block)(const FrontShape& shape, Groups block, const double* panel, double* factor);
    // The same columns of the factor in the rows below.
    void (*solve_rows)(const FrontShape& shape, Groups block, Groups rows, const double* panel,
                       double* factor);
    // target(row, column) -= or = - sum over the block, for rows not above columns. origin: of the target.
    void (*multiply)(const FrontShape& shape, Groups block, Groups columns, Groups rows, bool overwrite,
                     double* factor, int origin, double* target, int height);
    // Adds a block, or only what is not above its diagonal, to another matrix.
    void (*add)(const double* source, int source_height, int rows, int columns, bool lower, double* target,
                int target_height);
    // Solves with the pivots of a front and passes the result on to its updates (forward), and the reverse.
    void (*forward)(const FrontShape& shape, const double* factor, double* pivots, double* updates);
    // scratch: four numbers a pivot
    void (*backward)(const FrontShape& shape, const double* factor, double* pivots, const double* updates,
                     double* scratch);
};

// The fastest ones that this processor can run, and those that every processor can.
const FrontKernels& front_kernels();
const FrontKernels& portable_front_kernels();

} // namespace cholesky
