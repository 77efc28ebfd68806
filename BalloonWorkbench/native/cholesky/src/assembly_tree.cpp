// SPDX-License-Identifier: LGPL-2.1-or-later
#include "assembly_tree.h"

#include <algorithm>
#include <utility>

namespace cholesky {
namespace {

struct Supernode {
    std::vector<int> columns, rows; // vertices by their place in the given order
    std::vector<int> children;
    int pivots = 0, updates = 0;
    bool merged = false;
};

// Fundamental supernodes: the tree of Liu (1990), a column joining a child that has the same rows.
std::vector<Supernode> supernodes(const Graph& graph, const std::vector<int>& order) {
    const int count = graph.size();
    std::vector<int> place(count), seen(count, -1), rows;
    for (int i = 0; i < count; ++i)
        place[order[i]] = i;
    std::vector<Supernode> nodes;
    std::vector<int> waiting(count, -1), next; // supernodes by the first of their rows, as lists
    for (int column = 0; column < count; ++column) {
        seen[column] = column;
        rows.clear();
        const auto add = [&](int row) {
            if (row > column && seen[row] != column) {
                seen[row] = column;
                rows.push_back(row);
            }
        };
        for (int u : Neighbours{graph, order[column]})
            add(place[u]);
        for (int child = waiting[column]; child >= 0; child = next[child]) {
            for (int row : nodes[child].rows)
                add(row);
        }
        int host = -1;
        for (int child = waiting[column]; child >= 0; child = next[child]) {
            if (nodes[child].rows.size() == rows.size() + 1)
                host = child;
        }
        if (host < 0) {
            host = static_cast<int>(nodes.size());
            nodes.emplace_back();
            next.push_back(-1);
        }
        Supernode& node = nodes[host];
        for (int child = waiting[column]; child >= 0; child = next[child]) {
            if (child != host)
                node.children.push_back(child);
        }
        node.columns.push_back(column);
        node.rows = rows;
        if (!rows.empty()) {
            const int first = *std::min_element(rows.begin(), rows.end());
            next[host] = waiting[first];
            waiting[first] = host;
        }
    }
    return nodes;
}

void count_unknowns(std::vector<Supernode>& nodes, const std::vector<int>& order,
                    const std::vector<int>& widths) {
    for (Supernode& node : nodes) {
        for (int column : node.columns)
            node.pivots += widths[order[column]];
        for (int row : node.rows)
            node.updates += widths[order[row]];
    }
}

// Relaxed supernodes (Ashcraft and Grimes 1989): merges children into a node while a front with some more
// zeros is faster than two fronts.
void merge_children(std::vector<Supernode>& nodes, int parent) {
    Supernode& node = nodes[parent];
    std::vector<int> kept, open = std::move(node.children);
    // the child with most rows first: it adds the fewest zeros
    std::sort(open.begin(), open.end(), [&](int a, int b) {
        return std::make_pair(-nodes[a].updates, a) < std::make_pair(-nodes[b].updates, b);
    });
    for (int child : open) {
        Supernode& other = nodes[child];
        const double apart =
            time_of_front(other.pivots, other.updates) + time_of_front(node.pivots, node.updates);
        if (time_of_front(node.pivots + other.pivots, node.updates) > apart) {
            kept.push_back(child);
            continue;
        }
        other.columns.insert(other.columns.end(), node.columns.begin(), node.columns.end());
        node.columns = std::move(other.columns);
        node.pivots += other.pivots;
        kept.insert(kept.end(), other.children.begin(), other.children.end());
        other = Supernode{};
        other.merged = true;
    }
    node.children = std::move(kept);
}

// Puts the children in the order that needs least memory for the update matrices (Liu 1986).
double sort_children(std::vector<Supernode>& nodes, int top, const std::vector<double>& peak) {
    std::vector<int>& children = nodes[top].children;
    const auto left = [&](int child) { return 0.5 * nodes[child].updates * nodes[child].updates; };
    std::sort(children.begin(), children.end(), [&](int a, int b) {
        return std::make_pair(left(a) - peak[a], a) < std::make_pair(left(b) - peak[b], b);
    });
    double waiting = 0.0, highest = 0.0;
    for (int child : children) {
        highest = std::max(highest, waiting + peak[child]);
        waiting += left(child);
    }
    return std::max(highest, waiting + left(top));
}

} // namespace

double time_of_front(double pivots, double updates) {
    const double rows = pivots + updates;
    const double work = (rows * rows * rows - updates * updates * updates) / 3.0;
    return 1000.0 + 3.0 * rows * pivots + 0.7 * updates * updates + 0.05 * work;
}

AssemblyTree assembly_tree(const Graph& graph, const std::vector<int>& order,
                           const std::vector<int>& widths) {
    std::vector<Supernode> nodes = supernodes(graph, order);
    count_unknowns(nodes, order, widths);
    const int count = static_cast<int>(nodes.size());
    // a node follows its children by its last column only
    std::vector<std::pair<int, int>> by_last_column;
    by_last_column.reserve(nodes.size());
    for (int i = 0; i < count; ++i)
        by_last_column.emplace_back(nodes[i].columns.back(), i);
    std::sort(by_last_column.begin(), by_last_column.end());
    std::vector<double> peak(count, 0.0);
    for (const auto& [column, node] : by_last_column)
        merge_children(nodes, node);
    for (const auto& [column, node] : by_last_column) {
        if (!nodes[node].merged)
            peak[node] = sort_children(nodes, node, peak);
    }

    AssemblyTree tree;
    std::vector<int> place(graph.size());
    struct Visit {
        int node, next_child, first_front;
    };
    std::vector<Visit> path;
    for (const auto& [column, root] : by_last_column) {
        if (nodes[root].merged || !nodes[root].rows.empty())
            continue;
        path.push_back({root, 0, 0});
        while (!path.empty()) {
            Visit& visit = path.back();
            const Supernode& node = nodes[visit.node];
            if (visit.next_child < static_cast<int>(node.children.size())) {
                const int child = node.children[visit.next_child++];
                path.push_back({child, 0, 0});
                continue;
            }
            Front front{static_cast<int>(tree.order.size()),
                        static_cast<int>(node.columns.size()),
                        0,
                        static_cast<int>(node.rows.size()),
                        node.pivots,
                        node.updates,
                        -1};
            for (int old : node.columns) {
                place[old] = static_cast<int>(tree.order.size());
                tree.order.push_back(order[old]);
            }
            front.parent = visit.node; // the node for now
            tree.fronts.push_back(front);
            path.pop_back();
        }
    }
    // rows by their new places; the parent is the front of the first
    std::vector<int> front_at(graph.size());
    for (size_t f = 0; f < tree.fronts.size(); ++f) {
        const Front& front = tree.fronts[f];
        std::fill_n(front_at.begin() + front.first_vertex, front.vertices, static_cast<int>(f));
    }
    for (Front& front : tree.fronts) {
        front.first_row = static_cast<int>(tree.rows.size());
        for (int old : nodes[front.parent].rows)
            tree.rows.push_back(place[old]);
        std::sort(tree.rows.begin() + front.first_row, tree.rows.end());
        front.parent = front.rows > 0 ? front_at[tree.rows[front.first_row]] : -1;
    }
    return tree;
}

} // namespace cholesky
