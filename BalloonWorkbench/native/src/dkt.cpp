// SPDX-License-Identifier: LGPL-2.1-or-later
#include "dkt.h"

namespace film {
namespace {

constexpr int kSides[3][2] = {{0, 1}, {1, 2}, {2, 0}};

// Derivatives of the quadratic shape functions (corners, then sides) by the area coordinates.
Eigen::Matrix<double, 6, 3> shape_derivatives(const Eigen::Vector3d& at) {
    Eigen::Matrix<double, 6, 3> derivative = Eigen::Matrix<double, 6, 3>::Zero();
    for (int corner = 0; corner < 3; ++corner)
        derivative(corner, corner) = 4.0 * at[corner] - 1.0;
    for (int side = 0; side < 3; ++side) {
        const int i = kSides[side][0], j = kSides[side][1];
        derivative(3 + side, i) = 4.0 * at[j];
        derivative(3 + side, j) = 4.0 * at[i];
    }
    return derivative;
}

} // namespace

Matrix32 area_coordinate_gradients(const Matrix32& corners, double& area) {
    Matrix32 edge; // opposite to each corner
    for (int a = 0; a < 3; ++a)
        edge.row(a) = corners.row((a + 2) % 3) - corners.row((a + 1) % 3);
    const double double_area = edge(1, 0) * edge(2, 1) - edge(1, 1) * edge(2, 0);
    area = 0.5 * double_area;
    Matrix32 gradient;
    gradient.col(0) = -edge.col(1) / double_area;
    gradient.col(1) = edge.col(0) / double_area;
    return gradient;
}

Matrix6 rotation_stiffness(const Matrix32& corners, double nu) {
    double area = 0.0;
    const Matrix32 gradient = area_coordinate_gradients(corners, area);

    // rotations at the six nodes from those at the corners; Kirchhoff's hypothesis along each side
    Eigen::Matrix<double, 12, 6> rotation = Eigen::Matrix<double, 12, 6>::Zero();
    rotation.topRows<6>().setIdentity();
    for (int side = 0; side < 3; ++side) {
        const int i = kSides[side][0], j = kSides[side][1];
        const Eigen::Vector2d s = (corners.row(j) - corners.row(i)).transpose().normalized();
        const Eigen::Vector2d n(-s[1], s[0]);
        const Eigen::Matrix2d average = 0.5 * n * n.transpose() - 0.25 * s * s.transpose();
        rotation.block<2, 2>(6 + 2 * side, 2 * i) = average;
        rotation.block<2, 2>(6 + 2 * side, 2 * j) = average;
    }

    Eigen::Matrix3d law;
    law << 1.0, nu, 0.0, nu, 1.0, 0.0, 0.0, 0.0, 0.5 * (1.0 - nu);
    Matrix6 stiffness = Matrix6::Zero();
    for (int side = 0; side < 3; ++side) { // the middles of the sides integrate a quadratic exactly
        Eigen::Vector3d middle = Eigen::Vector3d::Zero();
        middle[kSides[side][0]] = middle[kSides[side][1]] = 0.5;
        const Eigen::Matrix<double, 6, 2> slope = shape_derivatives(middle) * gradient;
        Eigen::Matrix<double, 3, 6> curvature = Eigen::Matrix<double, 3, 6>::Zero();
        for (int node = 0; node < 6; ++node) {
            curvature.row(0) += slope(node, 0) * rotation.row(2 * node);
            curvature.row(1) += slope(node, 1) * rotation.row(2 * node + 1);
            curvature.row(2) +=
                slope(node, 1) * rotation.row(2 * node) + slope(node, 0) * rotation.row(2 * node + 1);
        }
        stiffness += area / 3.0 * curvature.transpose() * law * curvature;
    }
    return stiffness;
}

} // namespace film
