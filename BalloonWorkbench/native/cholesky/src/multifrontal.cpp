// SPDX-License-Identifier: LGPL-2.1-or-later
#include "multifrontal.h"

#include <algorithm>
#include <cmath>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace cholesky {
namespace {

constexpr int kBlock = 64;    // groups of pivots at a time: a strip of rows of so many columns stays in cache
constexpr int kColumns = 32;  // groups of columns that stay in cache while all rows pass
constexpr int kChunk = 12;    // groups of rows that one thread takes
constexpr int kTogether = 16; // right-hand sides that are solved while a front is in cache
constexpr double kLongFactorisation = 4e7; // [ns] shorter ones are not interrupted
constexpr std::chrono::milliseconds kInterruptInterval{30};

// Where the columns of a lower trapezium are cut so that all parts have as many numbers.
int cut(int height, int columns, int part, int parts) {
    if (part == parts)
        return columns;
    const double h = height, numbers = (h - 0.5 * columns) * columns * part / parts;
    return static_cast<int>(h - std::sqrt(std::max(h * h - 2.0 * numbers, 0.0)));
}

} // namespace

struct Multifrontal::Team {
    int index, count; // this thread among them
    bool led;         // by the thread that called
    ThreadPool* pool;
    double *panel, *stacks; // the front at work; updates of the subtree at work

    void barrier() const {
        if (count > 1)
            pool->barrier(index);
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

Multifrontal::Multifrontal(Pattern lower, const Blocks& blocks, int threads)
    : symbolic_(lower, blocks), schedule_(symbolic_, threads), kernels_(front_kernels()),
      factor_(symbolic_.factor_size), updates_(schedule_.shared_size), vectors_(symbolic_.vector_size),
      pool_(schedule_.is_parallel() ? threads : 1) {
    size_t of_shared = 0, of_subtrees = 0;
    for (int f : schedule_.shared_fronts)
        of_shared = std::max(of_shared, symbolic_.fronts[f].shape.panel_size());
    for (const Schedule::Subtree& subtree : schedule_.subtrees) {
        for (int f = subtree.first; f < subtree.last; ++f)
            of_subtrees = std::max(of_subtrees, symbolic_.fronts[f].shape.panel_size());
    }
    for (int thread = 0; thread < pool_.count(); ++thread) {
        panels_.emplace_back(thread == 0 ? std::max(of_shared, of_subtrees) : of_subtrees);
        stacks_.emplace_back(schedule_.thread_size);
    }
    lower = {};
#ifdef __GLIBC__
    malloc_trim(0); // the system gets back what the plan took for a moment, before it gives the factor
#endif
}

bool Multifrontal::run(const double* values, const double* diagonal, double* right_hand_side) {
    values_ = values;
    diagonal_ = diagonal;
    right_hand_side_ = right_hand_side;
    next_up_ = 0;
    next_down_ = 0;
    definite_ = true;
    interrupted_ = false;
    last_asked_ = std::chrono::steady_clock::now();
    pool_.run([this](int thread) { work(thread); });
    return definite_;
}

void Multifrontal::work(int thread) {
    const std::vector<Schedule::Subtree>& subtrees = schedule_.subtrees;
    const Team alone{0, 1, thread == 0, nullptr, panels_[thread].data(), stacks_[thread].data()};
    for (size_t b = next_up_++; b < subtrees.size(); b = next_up_++) {
        for (int f = subtrees[b].first; f < subtrees[b].last && definite_.load(std::memory_order_relaxed);
             ++f) {
            if (!go_up(f, alone))
                definite_ = false;
        }
    }
    const Team all{thread, pool_.close(thread), true, &pool_, panels_[0].data(), nullptr};
    for (int f : schedule_.shared_fronts) {
        if (!definite_ || !go_up(f, all))
            return;
    }
    if (!definite_ || right_hand_side_ == nullptr)
        return;
    if (thread == 0) {
        for (auto f = schedule_.shared_fronts.rbegin(); f != schedule_.shared_fronts.rend(); ++f)
            backward(*f, vectors_.data(), right_hand_side_, alone.panel);
    }
    all.barrier();
    for (size_t b = next_down_++; b < subtrees.size(); b = next_down_++) {
        for (int f = subtrees[b].last; f-- > subtrees[b].first;)
            backward(f, vectors_.data(), right_hand_side_, alone.panel);
    }
}

bool Multifrontal::go_up(int index, const Team& team) {
    if (values_ != nullptr && !factor(index, team))
        return false;
    if (right_hand_side_ != nullptr && team.index == 0)
        forward(index, vectors_.data(), right_hand_side_);
    return true;
}

bool Multifrontal::factor(int index, const Team& team) {
    assemble(index, team);
    if (!factor_panel(index, team))
        return false;
    const FrontShape& shape = symbolic_.fronts[index].shape;
    const int height = shape.height() - shape.columns();
    add_updates(index, team, false, shape.columns() + cut(height, height, team.index, team.count),
                shape.columns() + cut(height, height, team.index + 1, team.count), update(index, team));
    team.barrier();
    return true;
}

// Fills the panel of a front from the matrix and from what the children left.
void Multifrontal::assemble(int index, const Team& team) {
    double* const panel = team.panel;
    const Symbolic::Front& front = symbolic_.fronts[index];
    const size_t height = front.shape.height();
    const int first = cut(front.shape.height(), front.shape.columns(), team.index, team.count),
              last = cut(front.shape.height(), front.shape.columns(), team.index + 1, team.count);
    for (int column = first; column < last; ++column)
        std::fill(panel + column * height + column / kGroup * kGroup, panel + (column + 1) * height, 0.0);
    team.barrier();
    if (team.index == 0) {
        for (int e = front.first_entries; e < front.last_entries; ++e) {
            const Symbolic::Entries& entries = symbolic_.entries[e];
            const double* const from = values_ + entries.source;
            double* const to = panel + entries.target;
            const size_t stride = entries.along_row ? height : 1;
            for (int k = 0; k < entries.length; ++k)
                to[k * stride] = from[k];
        }
        for (int k = 0; diagonal_ != nullptr && k < front.pivots; ++k)
            panel[k * (height + 1)] += diagonal_[symbolic_.unknowns[front.first_unknown + k]];
        for (int k = front.pivots; k < front.shape.columns(); ++k)
            panel[k * (height + 1)] = 1.0;
    }
    team.barrier();
    add_updates(index, team, true, first, last, panel);
    team.barrier();
}

// Adds what the children left in the columns first .. last - 1 of a front, either to its pivots in the panel
// or to its own update.
void Multifrontal::add_updates(int index, const Team& team, bool to_pivots, int first, int last,
                               double* target) {
    const Symbolic::Front& front = symbolic_.fronts[index];
    const int pivots = front.shape.columns(), origin = to_pivots ? 0 : pivots;
    const int height = front.shape.height() - origin;
    const auto at = [&](int row, int column) {
        return target + static_cast<size_t>(column - origin) * height + (row - origin);
    };
    for (int k = 0; k < front.children; ++k) {
        const int child = symbolic_.children[front.first_child + k];
        const int child_height = kGroup * symbolic_.fronts[child].shape.update_groups;
        const Symbolic::Transfer* const begin = &symbolic_.transfers[symbolic_.fronts[child].first_transfer];
        const Symbolic::Transfer* const end = begin + symbolic_.fronts[child].transfers;
        for (const Symbolic::Transfer* a = begin; a < end; ++a) {
            if ((a->target < pivots) != to_pivots)
                continue;
            const int skip = std::max(first - a->target, 0);
            const int columns = std::min(last - a->target, a->length) - skip;
            if (columns <= 0)
                continue;
            const int from = a->source + skip, to = a->target + skip;
            const double* const source = update(child, team) + static_cast<size_t>(from) * child_height;
            kernels_.add(source + from, child_height, a->length - skip, columns, true, at(to, to), height);
            for (const Symbolic::Transfer* b = a + 1; b < end; ++b)
                kernels_.add(source + b->source, child_height, b->length, columns, false, at(b->target, to),
                             height);
        }
    }
}

bool Multifrontal::factor_panel(int index, const Team& team) {
    const FrontShape& shape = symbolic_.fronts[index].shape;
    double* const factor = factor_.data() + symbolic_.fronts[index].factor;
    double *const panel = team.panel, *const target = update(index, team);
    const int pivots = shape.pivot_groups, all = shape.groups();
    for (int first = 0; first < pivots; first += kBlock) {
        const Groups block{first, std::min(first + kBlock, pivots)};
        if (team.index == 0
            && ((team.led && !goes_on()) || !kernels_.factor_block(shape, block, panel, factor)))
            definite_ = false;
        team.barrier();
        if (!definite_)
            return false;
        team.share(block.last, all,
                   [&](Groups rows) { kernels_.solve_rows(shape, block, rows, panel, factor); });
        team.barrier();
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
        team.barrier();
    }
    return true;
}

void Multifrontal::set_interrupt(std::function<bool()> may_go_on) {
    double time = 0.0;
    for (const Symbolic::Front& front : symbolic_.fronts)
        time += front.time;
    if (time > kLongFactorisation)
        may_go_on_ = std::move(may_go_on);
}

bool Multifrontal::goes_on() {
    const auto now = std::chrono::steady_clock::now();
    if (may_go_on_ && now - last_asked_ > kInterruptInterval) {
        last_asked_ = now;
        interrupted_ = interrupted_ || !may_go_on_();
    }
    return !interrupted_;
}

// Where a front leaves its update.
double* Multifrontal::update(int index, const Team& team) {
    const size_t at = schedule_.update_at[index];
    return at < schedule_.thread_size ? team.stacks + at : updates_.data() + (at - schedule_.thread_size);
}

void Multifrontal::solve(double* right_hand_sides, int count) {
    const size_t size = symbolic_.unknowns.size();
    const int fronts = static_cast<int>(symbolic_.fronts.size());
    if (count > 1 && !many_)
        many_ = std::make_unique<AlignedArray>(kTogether * symbolic_.vector_size);
    for (int first = 0; first < count; first += kTogether) {
        const int last = std::min(first + kTogether, count);
        const auto vectors = [&](int field) {
            return count > 1 ? many_->data() + (field - first) * symbolic_.vector_size : vectors_.data();
        };
        for (int f = 0; f < fronts; ++f) {
            for (int field = first; field < last; ++field)
                forward(f, vectors(field), right_hand_sides + field * size);
        }
        for (int f = fronts; f-- > 0;) {
            for (int field = first; field < last; ++field)
                backward(f, vectors(field), right_hand_sides + field * size, panels_[0].data());
        }
    }
}

void Multifrontal::forward(int index, double* vectors, const double* right_hand_side) {
    const Symbolic::Front& front = symbolic_.fronts[index];
    double* const vector = vectors + front.vector;
    std::fill(vector + front.pivots, vector + front.shape.height(), 0.0);
    for (int k = 0; k < front.pivots; ++k)
        vector[k] = right_hand_side[symbolic_.unknowns[front.first_unknown + k]];
    for (int k = 0; k < front.children; ++k) {
        const Symbolic::Front& child = symbolic_.fronts[symbolic_.children[front.first_child + k]];
        const double* const update = vectors + child.vector + child.shape.columns();
        for (int t = child.first_transfer; t < child.first_transfer + child.transfers; ++t) {
            const Symbolic::Transfer& transfer = symbolic_.transfers[t];
            for (int i = 0; i < transfer.length; ++i)
                vector[transfer.target + i] += update[transfer.source + i];
        }
    }
    kernels_.forward(front.shape, factor_.data() + front.factor, vector, vector + front.shape.columns());
}

void Multifrontal::backward(int index, double* vectors, double* right_hand_side, double* scratch) {
    const Symbolic::Front& front = symbolic_.fronts[index];
    double* const vector = vectors + front.vector;
    double* const update = vector + front.shape.columns();
    for (int t = front.first_transfer; t < front.first_transfer + front.transfers; ++t) {
        const Symbolic::Transfer& transfer = symbolic_.transfers[t];
        std::copy_n(vectors + symbolic_.fronts[front.parent].vector + transfer.target, transfer.length,
                    update + transfer.source);
    }
    kernels_.backward(front.shape, factor_.data() + front.factor, vector, update, scratch);
    for (int k = 0; k < front.pivots; ++k)
        right_hand_side[symbolic_.unknowns[front.first_unknown + k]] = vector[k];
}

size_t Multifrontal::bytes() const {
    size_t sum = symbolic_.bytes() + schedule_.update_at.capacity() * sizeof(size_t) + factor_.bytes()
                 + updates_.bytes() + vectors_.bytes() + (many_ ? many_->bytes() : 0);
    for (size_t thread = 0; thread < panels_.size(); ++thread)
        sum += panels_[thread].bytes() + stacks_[thread].bytes();
    return sum;
}

} // namespace cholesky
