// SPDX-License-Identifier: LGPL-2.1-or-later
#include "separator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace cholesky {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kDirections = 6; // along the rows of an even triangle mesh and halfway between
constexpr int kBands = 96;     // places of the cut in each direction
constexpr double kSmallestPart = 0.1;

// Multiplications for a dissected part of n vertices with h neighbours outside. The coefficients solve the
// recursion for squares: the front of the separator, then two halves of the part.
double work_of_part(double n, double h) {
    const double width = std::sqrt(n);
    return width * (18.0 * n + 4.5 * width * h + 1.3 * h * h);
}

struct Size {
    int vertices = 0, outside = 0; // those with neighbours outside
    Size operator+(const Size& o) const { return {vertices + o.vertices, outside + o.outside}; }
    Size operator-(const Size& o) const { return {vertices - o.vertices, outside - o.outside}; }
    Size& operator+=(const Size& o) { return *this = *this + o; }
    Size& operator-=(const Size& o) { return *this = *this - o; }
};

double work_of_cut(const Size& left, const Size& right, const Size& separator) {
    const double s = separator.vertices, h = (left + right + separator).outside;
    return s * (s * s / 3.0 + s * h + h * h) + work_of_part(left.vertices, left.outside + s)
           + work_of_part(right.vertices, right.outside + s);
}

struct Cut {
    double work = std::numeric_limits<double>::infinity();
    Point direction{};
    double place = 0.0;
    bool separator_on_right = false;
};

// The direction of the rows of an even triangle mesh: edges repeat every 60 degrees.
double row_angle(const Graph& graph, const std::vector<Point>& points) {
    double cosine = 0.0, sine = 0.0; // of six times the angle
    for (int v = 0; v < graph.size(); ++v) {
        for (int u : Neighbours{graph, v}) {
            const double x = points[u][0] - points[v][0], y = points[u][1] - points[v][1];
            const double square = x * x + y * y;
            if (u > v && square > 0.0) {
                const double c = (x * x - y * y) / square, s = 2.0 * x * y / square; // of twice the angle
                cosine += c * (c * c - 3.0 * s * s);
                sine += s * (3.0 * c * c - s * s);
            }
        }
    }
    return std::atan2(sine, cosine) / 6.0;
}

class StraightCuts {
public:
    StraightCuts(const Graph& graph, const std::vector<Point>& points, const std::vector<char>& outside)
        : graph_(graph), points_(points), outside_(outside), along_(graph.size()), band_(graph.size()) {}

    // Tries the cuts across a direction, from band to band.
    void try_direction(const Point& direction, Cut& best) {
        const int count = graph_.size();
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (int v = 0; v < count; ++v) {
            along_[v] = direction[0] * points_[v][0] + direction[1] * points_[v][1];
            low = std::min(low, along_[v]);
            high = std::max(high, along_[v]);
        }
        const double scale = kBands / (high - low);
        if (!(high > low) || !std::isfinite(scale))
            return;
        for (int v = 0; v < count; ++v) {
            const double band = (along_[v] - low) * scale;
            band_[v] = band > 0.0 ? static_cast<int>(std::min(band, kBands - 1.0)) : 0;
        }
        const Counts counts = count_bands();
        const int smallest = static_cast<int>(kSmallestPart * count);
        for (int place = 1; place < kBands; ++place) {
            const Size left = counts.before[place], right = counts.before[kBands] - left;
            if (left.vertices < smallest || right.vertices < smallest)
                continue;
            for (bool on_right : {false, true}) {
                const Size rim = on_right ? counts.right_rim[place] : counts.left_rim[place];
                const double work =
                    on_right ? work_of_cut(left, right - rim, rim) : work_of_cut(left - rim, right, rim);
                if (work < best.work)
                    best = {work, direction, low + place / scale, on_right};
            }
        }
    }

private:
    // How many vertices each place of the cut has before it, on its left rim and on its right rim.
    struct Counts {
        std::array<Size, kBands + 1> before{}, left_rim{}, right_rim{};
    };

    Counts count_bands() const {
        Counts counts; // first the changes from place to place, then their sums
        for (int v = 0; v < graph_.size(); ++v) {
            int first = band_[v], last = band_[v];
            for (int u : Neighbours{graph_, v}) {
                first = std::min(first, band_[u]);
                last = std::max(last, band_[u]);
            }
            const Size one{1, outside_[v]};
            counts.before[band_[v] + 1] += one;
            if (last > band_[v]) {
                counts.left_rim[band_[v] + 1] += one;
                counts.left_rim[last + 1] -= one;
            }
            if (first < band_[v]) {
                counts.right_rim[first + 1] += one;
                counts.right_rim[band_[v] + 1] -= one;
            }
        }
        for (auto* sizes : {&counts.before, &counts.left_rim, &counts.right_rim})
            std::partial_sum(sizes->begin(), sizes->end(), sizes->begin());
        return counts;
    }

    const Graph& graph_;
    const std::vector<Point>& points_;
    const std::vector<char>& outside_;
    std::vector<double> along_;
    std::vector<int> band_;
};

} // namespace

std::vector<Part> bisect(const Graph& graph, const std::vector<Point>& points,
                         const std::vector<char>& outside) {
    StraightCuts sweep(graph, points, outside);
    Cut best;
    const double first_angle = row_angle(graph, points);
    for (int k = 0; k < kDirections; ++k) {
        const double angle = first_angle + k * kPi / kDirections;
        sweep.try_direction({std::cos(angle), std::sin(angle)}, best);
    }
    const bool drawn = std::isfinite(best.work); // else the numbers of the vertices must do
    std::vector<Part> side(graph.size());
    for (int v = 0; v < graph.size(); ++v) {
        const double along = best.direction[0] * points[v][0] + best.direction[1] * points[v][1];
        side[v] = (drawn ? along < best.place : v < graph.size() / 2) ? Part::left : Part::right;
    }
    std::vector<Part> part = side;
    const Part thinned = best.separator_on_right ? Part::right : Part::left;
    for (int v = 0; v < graph.size(); ++v) {
        const auto across = [&](int u) { return side[u] != thinned; };
        if (side[v] == thinned && std::any_of(graph.begin(v), graph.end(v), across))
            part[v] = Part::separator;
    }
    return part;
}

} // namespace cholesky
