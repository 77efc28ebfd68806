// SPDX-License-Identifier: LGPL-2.1-or-later
#include "schedule.h"

#include <algorithm>
#include <utility>

namespace film {
namespace {

constexpr double kSharingPays = 2e5; // [ns]
constexpr double kMeetings = 5e3;    // [ns] that threads lose on a front they share
constexpr int kBranches = 16;        // tried, for each thread

// Stacks of numbers, of which only the heights matter here.
struct Stacks {
    std::vector<size_t> height, highest;

    int add() {
        height.push_back(0);
        highest.push_back(0);
        return static_cast<int>(height.size()) - 1;
    }
    size_t push(int stack, size_t size) {
        const size_t at = height[stack];
        height[stack] += size;
        highest[stack] = std::max(highest[stack], height[stack]);
        return at;
    }
    void pop(int stack, size_t size) { height[stack] -= size; }
};

} // namespace

Schedule::Schedule(const CholeskyPlan& plan, int threads) : update_at(plan.fronts.size()) {
    double time = 0.0;
    for (const CholeskyPlan::Front& front : plan.fronts)
        time += front.time;
    if (threads > 1 && time > kSharingPays)
        grow_branches(plan, threads);
    else
        branches.push_back({0, static_cast<int>(plan.fronts.size())});
    place_updates(plan);
}

// Cuts the tree where the branches, the longest first, keep all threads busy for the shortest time.
void Schedule::grow_branches(const CholeskyPlan& plan, int threads) {
    const std::vector<CholeskyPlan::Front>& fronts = plan.fronts;
    const auto shorter = [&](int a, int b) {
        return std::make_pair(fronts[a].time_below, -a) < std::make_pair(fronts[b].time_below, -b);
    };
    std::vector<int> tops, best; // roots of branches, as a heap
    for (size_t f = 0; f < fronts.size(); ++f) {
        if (fronts[f].parent < 0)
            tops.push_back(static_cast<int>(f));
    }
    std::make_heap(tops.begin(), tops.end(), shorter);
    double trunk_time = 0.0, shortest = 0.0;
    while (!tops.empty() && static_cast<int>(tops.size()) <= kBranches * threads) {
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
        const CholeskyPlan::Front& front = fronts[tops.back()];
        tops.pop_back();
        trunk_time += kMeetings + front.time / threads;
        for (int k = 0; k < front.children; ++k) {
            tops.push_back(plan.children[front.first_child + k]);
            std::push_heap(tops.begin(), tops.end(), shorter);
        }
    }
    std::vector<char> in_branch(fronts.size(), 0);
    for (int top : best) {
        int first = top;
        while (fronts[first].children > 0)
            first = plan.children[fronts[first].first_child];
        branches.push_back({first, top + 1});
        std::fill(in_branch.begin() + first, in_branch.begin() + top + 1, char{1});
    }
    for (size_t f = 0; f < fronts.size(); ++f) {
        if (!in_branch[f])
            trunk.push_back(static_cast<int>(f));
    }
}

// Updates wait for the parent's work on two stacks, for fronts at even and at odd depths of the tree: those
// that the parent takes are then always uppermost on one, and its own goes onto the other.
void Schedule::place_updates(const CholeskyPlan& plan) {
    const std::vector<CholeskyPlan::Front>& fronts = plan.fronts;
    std::vector<int> odd(fronts.size(), 0), stack_of(fronts.size());
    for (size_t f = fronts.size(); f-- > 0;) {
        if (fronts[f].parent >= 0)
            odd[f] = 1 - odd[fronts[f].parent];
    }
    Stacks stacks;
    const auto place = [&](int f, const std::array<int, 2>& pair) {
        stack_of[f] = pair[odd[f]];
        update_at[f] = stacks.push(stack_of[f], fronts[f].shape.update_size());
        for (int k = 0; k < fronts[f].children; ++k) {
            const int child = plan.children[fronts[f].first_child + k];
            stacks.pop(stack_of[child], fronts[child].shape.update_size());
        }
    };
    for (const Branch& branch : branches) {
        const std::array<int, 2> pair{stacks.add(), stacks.add()};
        for (int f = branch.first; f < branch.last; ++f)
            place(f, pair);
    }
    const std::array<int, 2> pair{stacks.add(), stacks.add()};
    for (int f : trunk)
        place(f, pair);
    std::vector<size_t> begin;
    for (size_t size : stacks.highest) {
        begin.push_back(update_size);
        update_size += size;
    }
    for (size_t f = 0; f < fronts.size(); ++f)
        update_at[f] += begin[stack_of[f]];
}

} // namespace film
