// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nested_dissection.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "minimum_degree.h"

namespace cholesky {
namespace {

constexpr size_t kLeaf = 25; // vertices of a part that minimum degree orders better than a cut

class Dissection {
public:
    Dissection(const Graph& graph, const std::vector<Point>& points)
        : graph_(graph), points_(points), local_(graph.size(), -1) {}

    // Writes an order of a part whose neighbours outside are eliminated later.
    void order(std::vector<int> vertices, int* out) {
        if (vertices.size() <= kLeaf)
            return order_leaf(std::move(vertices), out);
        std::array<std::vector<int>, 3> parts = split(vertices);
        vertices = {};
        int* const second = out + parts[0].size();
        sort_along(parts[2]);
        std::copy(parts[2].begin(), parts[2].end(), second + parts[1].size());
        order(std::move(parts[0]), out);
        order(std::move(parts[1]), second);
    }

private:
    // Two parts and their separator.
    std::array<std::vector<int>, 3> split(const std::vector<int>& vertices) {
        const int count = static_cast<int>(vertices.size());
        for (int i = 0; i < count; ++i)
            local_[vertices[i]] = i;
        Graph part;
        part.first.reserve(count + 1);
        part.neighbour.reserve(7 * vertices.size());
        std::vector<Point> points(count);
        std::vector<char> outside(count, 0);
        for (int i = 0; i < count; ++i) {
            points[i] = points_[vertices[i]];
            for (int u : Neighbours{graph_, vertices[i]}) {
                if (local_[u] >= 0)
                    part.neighbour.push_back(local_[u]);
                else
                    outside[i] = 1;
            }
            part.first.push_back(static_cast<int>(part.neighbour.size()));
        }
        for (int v : vertices)
            local_[v] = -1;
        const std::vector<Part> side = bisect(part, points, outside);
        std::array<std::vector<int>, 3> parts;
        for (int i = 0; i < count; ++i)
            parts[static_cast<int>(side[i])].push_back(vertices[i]);
        return parts;
    }

    void order_leaf(std::vector<int> vertices, int* out) {
        const int inner = static_cast<int>(vertices.size());
        for (int i = 0; i < inner; ++i)
            local_[vertices[i]] = i;
        Graph part; // with the neighbours outside as its last vertices
        for (int i = 0; i < inner; ++i) {
            for (int u : Neighbours{graph_, vertices[i]}) {
                if (local_[u] < 0) {
                    local_[u] = static_cast<int>(vertices.size());
                    vertices.push_back(u);
                }
                part.neighbour.push_back(local_[u]);
            }
            part.first.push_back(static_cast<int>(part.neighbour.size()));
        }
        part.first.resize(vertices.size() + 1, part.first.back());
        for (int v : vertices)
            local_[v] = -1;
        for (int i : minimum_degree(part, inner))
            *out++ = vertices[i];
    }

    // Neighbours along a separator become neighbours in the order: rows of fronts then run together.
    void sort_along(std::vector<int>& vertices) const {
        Point mean{};
        for (int v : vertices) {
            for (int k = 0; k < 2; ++k)
                mean[k] += points_[v][k] / static_cast<double>(vertices.size());
        }
        double cosine = 0.0, sine = 0.0; // of twice the angle of the longest extent
        for (int v : vertices) {
            const double x = points_[v][0] - mean[0], y = points_[v][1] - mean[1];
            cosine += x * x - y * y;
            sine += 2.0 * x * y;
        }
        const double angle = 0.5 * std::atan2(sine, cosine);
        const Point axis{std::cos(angle), std::sin(angle)};
        std::vector<std::pair<double, int>> sorted;
        sorted.reserve(vertices.size());
        for (int v : vertices)
            sorted.emplace_back(axis[0] * points_[v][0] + axis[1] * points_[v][1], v);
        std::sort(sorted.begin(), sorted.end());
        for (size_t i = 0; i < vertices.size(); ++i)
            vertices[i] = sorted[i].second;
    }

    const Graph& graph_;
    const std::vector<Point>& points_;
    std::vector<int> local_; // place in the part at work, else -1
};

} // namespace

std::vector<int> nested_dissection(const Graph& graph, const std::vector<Point>& points) {
    std::vector<int> all(graph.size()), order(graph.size());
    for (int v = 0; v < graph.size(); ++v)
        all[v] = v;
    Dissection(graph, points).order(std::move(all), order.data());
    return order;
}

} // namespace cholesky
