// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>

#include <Eigen/Dense>

namespace film {

using Vectors = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

// A hinge of the sealed band along a seam in space: one panel's half of the band keeps its curvature in the
// plane across the director of the middle vertex. The same law as in the NumPy solver (space_band.py).
class SpaceHinge {
public:
    static constexpr int kUnknowns = 11; // x, y, z of three vertices, two turns of the middle one's director
    using Force = Eigen::Matrix<double, kUnknowns, 1>;
    using Stiffness = Eigen::Matrix<double, kUnknowns, kUnknowns>;

    // rest: the vertices in the flat film.
    SpaceHinge(const std::array<int, 3>& vertex, const std::array<Eigen::Vector2d, 3>& rest, double rigidity);

    const std::array<int, 3>& vertices() const { return vertex_; }

    double energy(const Vectors& positions, const Vectors& directors) const;

    // frame: two unit vectors across the director as columns; exact: with the second derivatives of the kink.
    void derivatives(const Vectors& positions, const Vectors& directors,
                     const Eigen::Matrix<double, 3, 2>& frame, bool exact, Force& force,
                     Stiffness& stiffness) const;

private:
    Eigen::Vector3d edge(const Vectors& positions, int which) const {
        return positions.row(vertex_[which + 1]) - positions.row(vertex_[which]);
    }

    std::array<int, 3> vertex_;
    Eigen::Matrix2d rotation_; // by the turning angle at rest
    double before_, after_;    // one over the length of each edge at rest
    double stiffness_;
};

} // namespace film
