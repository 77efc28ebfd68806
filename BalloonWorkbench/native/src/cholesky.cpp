// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cholesky.h"

#include <algorithm>
#include <cmath>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace film {
namespace {

constexpr int kBlock = 64;    // groups of pivots at a time: a strip of rows of so many columns stays in cache
constexpr int kColumns = 32;  // groups of columns that stay in cache while all rows pass
constexpr int kChunk = 12;    // groups of rows that one thread takes
constexpr double kLong = 4e7; // [ns] a factorisation during which questions are asked
constexpr std::chrono::milliseconds kPatience{30}; // between two of them

// Where the columns of a lower trapezium are cut so that all parts have as many numbers.
int cut(int height, int columns, int part, int parts) {
    if (part == parts)
        return columns;
    const double h = height, numbers = (h - 0.5 * columns) * columns * part / parts;
    return static_cast<int>(h - std::sqrt(std::max(h * h - 2.0 * numbers, 0.0)));
}

} // namespace

struct Cholesky::Team {
    int index, count; // this thread among them
    bool led;         // by the thread that called
    Workers* workers;
    double *panel, *stacks; // the front at work; updates of the branch at work

    void meet() const {
        if (count > 1)
            workers->meet(index);
    }
    // Calls work with this thread's share of the groups first .. last - 1.
    template <typename Work>
    void share(int first, int last, const Work& work) const {
        if (count == 1)
            return work(Groups{first, last});
        for (int chunk = first + index * kChunk; chunk < last; chunk += count * kChunk)
            work(Groups{chunk, std::min(chunk + kChunk, last)});
    }
};

Cholesky::Cholesky(SymmetricMatrix lower, const Blocks& blocks, int threads)
    : plan_(lower, blocks), schedule_(plan_, threads), kernels_(front_kernels()), factor_(plan_.factor_size),
      updates_(schedule_.shared_size), vectors_(plan_.vector_size),
      workers_(schedule_.shared() ? threads : 1) {
    size_t in_trunk = 0, in_branch = 0;
    for (int f : schedule_.trunk)
        in_trunk = std::max(in_trunk, plan_.fronts[f].shape.panel_size());
    for (const Schedule::Branch& branch : schedule_.branches) {
        for (int f = branch.first; f < branch.last; ++f)
            in_branch = std::max(in_branch, plan_.fronts[f].shape.panel_size());
    }
    for (int thread = 0; thread < workers_.count(); ++thread) {
        panels_.emplace_back(thread == 0 ? std::max(in_trunk, in_branch) : in_branch);
        stacks_.emplace_back(schedule_.thread_size);
    }
    SymmetricMatrix().swap(lower);
#ifdef __GLIBC__
    malloc_trim(0); // the system gets back what the plan took for a moment, before it gives the factor
#endif
}

bool Cholesky::factorise(const double* values, const double* diagonal) {
    return run(values, diagonal, nullptr);
}

void Cholesky::solve(double* right_hand_side) {
    run(nullptr, nullptr, right_hand_side);
}

bool Cholesky::factorise_and_solve(const double* values, const double* diagonal, double* right_hand_side) {
    return run(values, diagonal, right_hand_side);
}

bool Cholesky::run(const double* values, const double* diagonal, double* right_hand_side) {
    values_ = values;
    diagonal_ = diagonal;
    right_hand_side_ = right_hand_side;
    next_up_ = 0;
    next_down_ = 0;
    definite_ = true;
    stopped_ = false;
    asked_ = std::chrono::steady_clock::now();
    workers_.run([this](int thread) { work(thread); });
    return definite_;
}

// Up the tree: the factor and the forward substitution. Down: the backward substitution.
void Cholesky::work(int thread) {
    const std::vector<Schedule::Branch>& branches = schedule_.branches;
    const Team alone{0, 1, thread == 0, nullptr, panels_[thread].data(), stacks_[thread].data()};
    for (size_t b = next_up_++; b < branches.size(); b = next_up_++) {
        for (int f = branches[b].first; f < branches[b].last && definite_.load(std::memory_order_relaxed);
             ++f) {
            if (!go_up(f, alone))
                definite_ = false;
        }
    }
    const Team all{thread, workers_.gather(thread), true, &workers_, panels_[0].data(), nullptr};
    for (int f : schedule_.trunk) {
        if (!definite_ || !go_up(f, all))
            return;
    }
    if (!definite_ || right_hand_side_ == nullptr)
        return;
    if (thread == 0) {
        for (auto f = schedule_.trunk.rbegin(); f != schedule_.trunk.rend(); ++f)
            backward(*f, alone.panel);
    }
    all.meet();
    for (size_t b = next_down_++; b < branches.size(); b = next_down_++) {
        for (int f = branches[b].last; f-- > branches[b].first;)
            backward(f, alone.panel);
    }
}

bool Cholesky::go_up(int index, const Team& team) {
    if (values_ != nullptr && !factor(index, team))
        return false;
    if (right_hand_side_ != nullptr && team.index == 0)
        forward(index);
    return true;
}

bool Cholesky::factor(int index, const Team& team) {
    assemble(index, team);
    if (!factor_panel(index, team))
        return false;
    const FrontShape& shape = plan_.fronts[index].shape;
    const int height = shape.height() - shape.columns();
    add_updates(index, team, false, shape.columns() + cut(height, height, team.index, team.count),
                shape.columns() + cut(height, height, team.index + 1, team.count), update(index, team));
    team.meet();
    return true;
}

// Fills the panel of a front from the matrix and from what the children left.
void Cholesky::assemble(int index, const Team& team) {
    double* const panel = team.panel;
    const CholeskyPlan::Front& front = plan_.fronts[index];
    const size_t height = front.shape.height();
    const int first = cut(front.shape.height(), front.shape.columns(), team.index, team.count),
              last = cut(front.shape.height(), front.shape.columns(), team.index + 1, team.count);
    for (int column = first; column < last; ++column)
        std::fill(panel + column * height + column / kGroup * kGroup, panel + (column + 1) * height, 0.0);
    team.meet();
    if (team.index == 0) {
        for (int e = front.first_entries; e < front.last_entries; ++e) {
            const CholeskyPlan::Entries& entries = plan_.entries[e];
            const double* const from = values_ + entries.source;
            double* const to = panel + entries.target;
            const size_t stride = entries.along_row ? height : 1;
            for (int k = 0; k < entries.length; ++k)
                to[k * stride] = from[k];
        }
        for (int k = 0; diagonal_ != nullptr && k < front.pivots; ++k)
            panel[k * (height + 1)] += diagonal_[plan_.unknowns[front.first_unknown + k]];
        for (int k = front.pivots; k < front.shape.columns(); ++k)
            panel[k * (height + 1)] = 1.0;
    }
    team.meet();
    add_updates(index, team, true, first, last, panel);
    team.meet();
}

// Adds what the children left in the columns first .. last - 1 of a front, either to its pivots in the panel
// or to its own update.
void Cholesky::add_updates(int index, const Team& team, bool to_pivots, int first, int last, double* target) {
    const CholeskyPlan::Front& front = plan_.fronts[index];
    const int pivots = front.shape.columns(), origin = to_pivots ? 0 : pivots;
    const int height = front.shape.height() - origin;
    const auto at = [&](int row, int column) {
        return target + static_cast<size_t>(column - origin) * height + (row - origin);
    };
    for (int k = 0; k < front.children; ++k) {
        const int child = plan_.children[front.first_child + k];
        const int child_height = kGroup * plan_.fronts[child].shape.update_groups;
        const CholeskyPlan::Transfer* const begin = &plan_.transfers[plan_.fronts[child].first_transfer];
        const CholeskyPlan::Transfer* const end = begin + plan_.fronts[child].transfers;
        for (const CholeskyPlan::Transfer* a = begin; a < end; ++a) {
            if ((a->target < pivots) != to_pivots)
                continue;
            const int skip = std::max(first - a->target, 0);
            const int columns = std::min(last - a->target, a->length) - skip;
            if (columns <= 0)
                continue;
            const int from = a->source + skip, to = a->target + skip;
            const double* const source = update(child, team) + static_cast<size_t>(from) * child_height;
            kernels_.add(source + from, child_height, a->length - skip, columns, true, at(to, to), height);
            for (const CholeskyPlan::Transfer* b = a + 1; b < end; ++b)
                kernels_.add(source + b->source, child_height, b->length, columns, false, at(b->target, to),
                             height);
        }
    }
}

bool Cholesky::factor_panel(int index, const Team& team) {
    const FrontShape& shape = plan_.fronts[index].shape;
    double* const factor = factor_.data() + plan_.fronts[index].factor;
    double *const panel = team.panel, *const target = update(index, team);
    const int pivots = shape.pivot_groups, all = shape.groups();
    for (int first = 0; first < pivots; first += kBlock) {
        const Groups block{first, std::min(first + kBlock, pivots)};
        if (team.index == 0
            && ((team.led && !may_go_on()) || !kernels_.factor_block(shape, block, panel, factor)))
            definite_ = false;
        team.meet();
        if (!definite_)
            return false;
        team.share(block.last, all,
                   [&](Groups rows) { kernels_.solve_rows(shape, block, rows, panel, factor); });
        team.meet();
        for (int column = block.last, last; column < all; column = last) {
            const bool in_panel = column < pivots;
            last = std::min(column + kColumns, in_panel ? pivots : all);
            const Groups columns{column, last};
            team.share(column, all, [&](Groups rows) {
                if (in_panel)
                    kernels_.multiply(shape, block, columns, rows, false, factor, 0, panel, shape.height());
                else
                    kernels_.multiply(shape, block, columns, rows, first == 0, factor, pivots, target,
                                      kGroup * shape.update_groups);
            });
        }
        team.meet();
    }
    return true;
}

void Cholesky::ask(std::function<bool()> question) {
    double time = 0.0;
    for (const CholeskyPlan::Front& front : plan_.fronts)
        time += front.time;
    if (time > kLong)
        question_ = std::move(question);
}

bool Cholesky::may_go_on() {
    const auto now = std::chrono::steady_clock::now();
    if (question_ && now - asked_ > kPatience) {
        asked_ = now;
        stopped_ = stopped_ || !question_();
    }
    return !stopped_;
}

// Where a front leaves its update.
double* Cholesky::update(int index, const Team& team) {
    const size_t at = schedule_.update_at[index];
    return at < schedule_.thread_size ? team.stacks + at : updates_.data() + (at - schedule_.thread_size);
}

void Cholesky::forward(int index) {
    const CholeskyPlan::Front& front = plan_.fronts[index];
    double* const vector = vectors_.data() + front.vector;
    std::fill(vector + front.pivots, vector + front.shape.height(), 0.0);
    for (int k = 0; k < front.pivots; ++k)
        vector[k] = right_hand_side_[plan_.unknowns[front.first_unknown + k]];
    for (int k = 0; k < front.children; ++k) {
        const CholeskyPlan::Front& child = plan_.fronts[plan_.children[front.first_child + k]];
        const double* const update = vectors_.data() + child.vector + child.shape.columns();
        for (int t = child.first_transfer; t < child.first_transfer + child.transfers; ++t) {
            const CholeskyPlan::Transfer& transfer = plan_.transfers[t];
            for (int i = 0; i < transfer.length; ++i)
                vector[transfer.target + i] += update[transfer.source + i];
        }
    }
    kernels_.forward(front.shape, factor_.data() + front.factor, vector, vector + front.shape.columns());
}

void Cholesky::backward(int index, double* scratch) {
    const CholeskyPlan::Front& front = plan_.fronts[index];
    double* const vector = vectors_.data() + front.vector;
    double* const update = vector + front.shape.columns();
    for (int t = front.first_transfer; t < front.first_transfer + front.transfers; ++t) {
        const CholeskyPlan::Transfer& transfer = plan_.transfers[t];
        std::copy_n(vectors_.data() + plan_.fronts[front.parent].vector + transfer.target, transfer.length,
                    update + transfer.source);
    }
    kernels_.backward(front.shape, factor_.data() + front.factor, vector, update, scratch);
    for (int k = 0; k < front.pivots; ++k)
        right_hand_side_[plan_.unknowns[front.first_unknown + k]] = vector[k];
}

size_t Cholesky::bytes() const {
    size_t sum = plan_.bytes() + schedule_.update_at.capacity() * sizeof(size_t) + factor_.bytes()
                 + updates_.bytes() + vectors_.bytes();
    for (size_t thread = 0; thread < panels_.size(); ++thread)
        sum += panels_[thread].bytes() + stacks_[thread].bytes();
    return sum;
}

} // namespace film
