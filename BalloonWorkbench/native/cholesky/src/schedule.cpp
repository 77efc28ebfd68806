// SPDX-License-Identifier: LGPL-2.1-or-later
#include "schedule.h"

#include <algorithm>
#include <utility>

namespace cholesky {
namespace {

constexpr double kSharingPays = 2e5; // [ns]
constexpr double kMeetings = 5e3;    // [ns] that threads lose on a front they share
constexpr int kSubtrees = 16;        // tried, for each thread

// A stack of numbers, of which only the height matters here.
struct Stack {
    size_t height = 0, highest = 0;

    size_t push(size_t size) {
        const size_t at = height;
        height += size;
        highest = std::max(highest, height);
        return at;
    }
    void pop(size_t size) { height -= size; }
};

} // namespace

Schedule::Schedule(const Symbolic& symbolic, int threads) : update_at(symbolic.fronts.size()) {
    double time = 0.0;
    for (const Symbolic::Front& front : symbolic.fronts)
        time += front.time;
    if (threads > 1 && time > kSharingPays)
        choose_subtrees(symbolic, threads);
    else
        subtrees.push_back({0, static_cast<int>(symbolic.fronts.size())});
    place_updates(symbolic);
}

// Cuts the tree where the subtrees, the longest first, keep all threads busy for the shortest time.
void Schedule::choose_subtrees(const Symbolic& symbolic, int threads) {
    const std::vector<Symbolic::Front>& fronts = symbolic.fronts;
    const auto shorter = [&](int a, int b) {
        return std::make_pair(fronts[a].time_below, -a) < std::make_pair(fronts[b].time_below, -b);
    };
    std::vector<int> tops, best; // roots of subtrees, as a heap
    for (size_t f = 0; f < fronts.size(); ++f) {
        if (fronts[f].parent < 0)
            tops.push_back(static_cast<int>(f));
    }
    std::make_heap(tops.begin(), tops.end(), shorter);
    double trunk_time = 0.0, shortest = 0.0;
    while (!tops.empty() && static_cast<int>(tops.size()) <= kSubtrees * threads) {
        std::vector<int> sorted = tops;
        std::sort(sorted.begin(), sorted.end(), [&](int a, int b) { return shorter(b, a); });
        std::vector<double> busy(threads, 0.0);
        for (int top : sorted)
            *std::min_element(busy.begin(), busy.end()) += fronts[top].time_below;
        const double time = *std::max_element(busy.begin(), busy.end()) + trunk_time;
        if (best.empty() || time < shortest) {
            shortest = time;
            best = std::move(sorted);
        }
        std::pop_heap(tops.begin(), tops.end(), shorter);
        const Symbolic::Front& front = fronts[tops.back()];
        tops.pop_back();
        trunk_time += kMeetings + front.time / threads;
        for (int k = 0; k < front.children; ++k) {
            tops.push_back(symbolic.children[front.first_child + k]);
            std::push_heap(tops.begin(), tops.end(), shorter);
        }
    }
    std::vector<char> in_branch(fronts.size(), 0);
    for (int top : best) {
        int first = top;
        while (fronts[first].children > 0)
            first = symbolic.children[fronts[first].first_child];
        subtrees.push_back({first, top + 1});
        std::fill(in_branch.begin() + first, in_branch.begin() + top + 1, char{1});
    }
    for (size_t f = 0; f < fronts.size(); ++f) {
        if (!in_branch[f])
            shared_fronts.push_back(static_cast<int>(f));
    }
}

// Updates wait for the parent's work on two stacks, for fronts at even and at odd depths of the tree: those
// that the parent takes are then always uppermost on one, and its own goes onto the other. Each thread has
// two for the subtree at work, the shared_fronts has two more, and what subtrees leave to the shared_fronts
// lies beside them.
void Schedule::place_updates(const Symbolic& symbolic) {
    const std::vector<Symbolic::Front>& fronts = symbolic.fronts;
    std::vector<char> odd(fronts.size(), 0);
    for (size_t f = fronts.size(); f-- > 0;) {
        if (fronts[f].parent >= 0)
            odd[f] = !odd[fronts[f].parent];
    }
    std::vector<char> left(fronts.size(), 0); // by a subtree to the shared_fronts
    for (const Subtree& subtree : subtrees)
        left[subtree.last - 1] = 1;
    const auto size = [&](int f) { return fronts[f].shape.update_size(); };
    const auto place = [&](int f, std::array<Stack, 2>& stacks) {
        if (!left[f])
            update_at[f] = stacks[odd[f]].push(size(f));
        for (int k = 0; k < fronts[f].children; ++k) {
            const int child = symbolic.children[fronts[f].first_child + k];
            if (!left[child])
                stacks[odd[child]].pop(size(child));
        }
    };
    std::array<Stack, 2> of_thread, of_trunk;
    for (const Subtree& subtree : subtrees) {
        for (int f = subtree.first; f < subtree.last; ++f)
            place(f, of_thread);
    }
    for (int f : shared_fronts)
        place(f, of_trunk);

    // one after the other: even and odd of a thread; even and odd of the shared_fronts, and what is left to
    // it
    thread_size = of_thread[0].highest + of_thread[1].highest;
    shared_size = of_trunk[0].highest + of_trunk[1].highest;
    for (const Subtree& subtree : subtrees) {
        for (int f = subtree.first; f < subtree.last; ++f)
            update_at[f] += odd[f] ? of_thread[0].highest : 0;
        update_at[subtree.last - 1] = thread_size + shared_size;
        shared_size += size(subtree.last - 1);
    }
    for (int f : shared_fronts)
        update_at[f] += thread_size + (odd[f] ? of_trunk[0].highest : 0);
}

} // namespace cholesky
