// SPDX-License-Identifier: LGPL-2.1-or-later
#include "symbolic.h"

#include <algorithm>

#include "assembly_tree.h"
#include "nested_dissection.h"

namespace cholesky {
namespace {

// Neighbouring rows of one block in one column of the matrix.
struct Run {
    int source, row, column, length;
};

std::vector<Run> runs_of(const Pattern& lower, const std::vector<int>& block_of_unknown) {
    const std::vector<int>&starts = lower.starts, &rows = lower.rows;
    std::vector<Run> runs;
    runs.reserve(rows.size() / 4 + starts.size());
    for (int column = 0; column < lower.columns(); ++column) {
        for (int k = starts[column]; k < starts[column + 1];) {
            const int first = k, block = block_of_unknown[rows[first]];
            do
                ++k;
            while (k < starts[column + 1] && rows[k] == rows[k - 1] + 1
                   && block_of_unknown[rows[k]] == block);
            runs.push_back({first, rows[first], column, k - first});
        }
    }
    return runs;
}

Graph graph_of(const std::vector<Run>& runs, const std::vector<int>& block_of_unknown, int blocks) {
    std::vector<std::pair<int, int>> edges; // each once, the earlier block first
    std::vector<int> seen(blocks, -1);
    for (const Run& run : runs) {
        const int from = block_of_unknown[run.column], to = block_of_unknown[run.row];
        if (from != to && seen[to] != from) {
            seen[to] = from;
            edges.emplace_back(from, to);
        }
    }
    Graph graph;
    graph.first.assign(blocks + 1, 0);
    for (const auto& [from, to] : edges) {
        ++graph.first[from + 1];
        ++graph.first[to + 1];
    }
    for (int v = 0; v < blocks; ++v)
        graph.first[v + 1] += graph.first[v];
    graph.neighbour.resize(graph.first.back());
    std::vector<int> next(graph.first.begin(), graph.first.end() - 1);
    for (const auto& [from, to] : edges) {
        graph.neighbour[next[from]++] = to;
        graph.neighbour[next[to]++] = from;
    }
    return graph;
}

class SymbolicBuilder {
public:
    SymbolicBuilder(Symbolic& symbolic, const AssemblyTree& tree, const std::vector<int>& first_unknown,
                    const std::vector<int>& block_of_unknown)
        : symbolic_(symbolic), tree_(tree), first_unknown_(first_unknown),
          block_of_unknown_(block_of_unknown), place_(tree.order.size()), row_(tree.order.size()) {
        for (size_t place = 0; place < tree.order.size(); ++place) {
            place_[tree.order[place]] = static_cast<int>(place);
            for (int k = 0; k < width(static_cast<int>(place)); ++k)
                symbolic.unknowns.push_back(first_unknown[tree.order[place]] + k);
        }
    }

    void add_fronts() {
        int unknown = 0;
        for (const Front& front : tree_.fronts) {
            const FrontShape shape(front.pivots, front.updates);
            symbolic_.fronts.push_back({shape, front.pivots, unknown, front.parent, 0, 0, 0, 0, 0, 0,
                                        symbolic_.factor_size, symbolic_.vector_size,
                                        time_of_front(front.pivots, front.updates), 0.0});
            unknown += front.pivots;
            symbolic_.factor_size += shape.factor_size();
            symbolic_.vector_size += shape.height();
        }
        for (Symbolic::Front& front : symbolic_.fronts) {
            front.time_below += front.time;
            if (front.parent >= 0) {
                symbolic_.fronts[front.parent].time_below += front.time_below;
                ++symbolic_.fronts[front.parent].children;
            }
        }
        int first = 0;
        for (Symbolic::Front& front : symbolic_.fronts) {
            front.first_child = first;
            first += front.children;
            front.children = 0;
        }
        symbolic_.children.resize(first);
        for (size_t f = 0; f < symbolic_.fronts.size(); ++f) {
            if (symbolic_.fronts[f].parent >= 0) {
                Symbolic::Front& parent = symbolic_.fronts[symbolic_.fronts[f].parent];
                symbolic_.children[parent.first_child + parent.children++] = static_cast<int>(f);
            }
        }
    }

    void add_entries(const std::vector<Run>& runs) {
        // the front of a run is that of the block eliminated first
        std::vector<int> front_at(tree_.order.size()), owner(runs.size());
        for (size_t f = 0; f < tree_.fronts.size(); ++f)
            std::fill_n(front_at.begin() + tree_.fronts[f].first_vertex, tree_.fronts[f].vertices,
                        static_cast<int>(f));
        std::vector<int> first(tree_.fronts.size() + 1, 0);
        for (size_t i = 0; i < runs.size(); ++i) {
            owner[i] = front_at[std::min(place_of(runs[i].row), place_of(runs[i].column))];
            ++first[owner[i] + 1];
        }
        for (size_t f = 0; f < tree_.fronts.size(); ++f)
            first[f + 1] += first[f];
        std::vector<int> sorted(runs.size());
        for (size_t i = 0; i < runs.size(); ++i)
            sorted[first[owner[i]]++] = static_cast<int>(i);
        symbolic_.entries.reserve(runs.size());
        size_t next = 0;
        for (size_t f = 0; f < tree_.fronts.size(); ++f) {
            number_rows(static_cast<int>(f));
            symbolic_.fronts[f].first_entries = static_cast<int>(next);
            for (; next < static_cast<size_t>(first[f]); ++next)
                symbolic_.entries.push_back(entries(runs[sorted[next]], symbolic_.fronts[f].shape.height()));
            symbolic_.fronts[f].last_entries = static_cast<int>(next);
        }
    }

    void add_transfers() {
        std::vector<std::vector<Symbolic::Transfer>> of_front(tree_.fronts.size());
        for (size_t parent = 0; parent < tree_.fronts.size(); ++parent) {
            const Symbolic::Front& front = symbolic_.fronts[parent];
            if (front.children == 0)
                continue;
            number_rows(static_cast<int>(parent));
            for (int k = 0; k < front.children; ++k) {
                const int child = symbolic_.children[front.first_child + k];
                const Front& from = tree_.fronts[child];
                std::vector<Symbolic::Transfer>& transfers = of_front[child];
                int source = 0;
                for (int r = 0; r < from.rows; ++r) {
                    const int place = tree_.rows[from.first_row + r], target = row_[place];
                    const bool joins = !transfers.empty() && target != front.shape.columns()
                                       && target == transfers.back().target + transfers.back().length;
                    if (joins)
                        transfers.back().length += width(place);
                    else
                        transfers.push_back({source, target, width(place)});
                    source += width(place);
                }
            }
        }
        for (size_t f = 0; f < tree_.fronts.size(); ++f) {
            symbolic_.fronts[f].first_transfer = static_cast<int>(symbolic_.transfers.size());
            symbolic_.transfers.insert(symbolic_.transfers.end(), of_front[f].begin(), of_front[f].end());
            symbolic_.fronts[f].transfers = static_cast<int>(of_front[f].size());
        }
    }

private:
    int width(int place) const {
        const int block = tree_.order[place];
        return first_unknown_[block + 1] - first_unknown_[block];
    }
    int place_of(int unknown) const { return place_[block_of_unknown_[unknown]]; }

    // Where the unknowns of each block begin in the panel of a front.
    void number_rows(int index) {
        const Front& front = tree_.fronts[index];
        int row = 0;
        for (int place = front.first_vertex; place < front.first_vertex + front.vertices; ++place) {
            row_[place] = row;
            row += width(place);
        }
        row = symbolic_.fronts[index].shape.columns();
        for (int r = front.first_row; r < front.first_row + front.rows; ++r) {
            row_[tree_.rows[r]] = row;
            row += width(tree_.rows[r]);
        }
    }

    int row_of(int unknown) const {
        return row_[place_of(unknown)] + unknown - first_unknown_[block_of_unknown_[unknown]];
    }

    Symbolic::Entries entries(const Run& run, int height) const {
        const int row = row_of(run.row), column = row_of(run.column);
        const bool swapped = row < column;
        const int target = swapped ? column + row * height : row + column * height;
        return {run.source, target, static_cast<short>(run.length), swapped};
    }

    Symbolic& symbolic_;
    const AssemblyTree& tree_;
    const std::vector<int>& first_unknown_; // of each block
    const std::vector<int>& block_of_unknown_;
    std::vector<int> place_; // of each block
    std::vector<int> row_;   // of each place, in the front at work
};

template <typename T>
size_t bytes_of(const std::vector<T>& v) {
    return v.capacity() * sizeof(T);
}

} // namespace

Symbolic::Symbolic(const Pattern& lower, const Blocks& blocks) {
    const int count = static_cast<int>(blocks.points.size());
    std::vector<int> first_unknown(count + 1, 0), widths(count);
    for (int block : blocks.block_of_unknown)
        ++widths[block];
    for (int block = 0; block < count; ++block)
        first_unknown[block + 1] = first_unknown[block] + widths[block];
    const std::vector<Run> runs = runs_of(lower, blocks.block_of_unknown);
    const Graph graph = graph_of(runs, blocks.block_of_unknown, count);
    const AssemblyTree tree = assembly_tree(graph, nested_dissection(graph, blocks.points), widths);
    SymbolicBuilder builder(*this, tree, first_unknown, blocks.block_of_unknown);
    builder.add_fronts();
    builder.add_entries(runs);
    builder.add_transfers();
}

size_t Symbolic::bytes() const {
    return bytes_of(fronts) + bytes_of(children) + bytes_of(entries) + bytes_of(transfers)
           + bytes_of(unknowns);
}

} // namespace cholesky
