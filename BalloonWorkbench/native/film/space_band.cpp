// SPDX-License-Identifier: LGPL-2.1-or-later
#include "space_band.h"

namespace film {

SpaceHinge::SpaceHinge(const std::array<int, 3>& vertex, const std::array<Eigen::Vector2d, 3>& rest,
                       double rigidity)
    : vertex_(vertex) {
    const Eigen::Vector2d before = rest[1] - rest[0], after = rest[2] - rest[1];
    const Eigen::Vector2d s = before.normalized(), n = after.normalized();
    rotation_ << s.dot(n), s[1] * n[0] - s[0] * n[1], s[0] * n[1] - s[1] * n[0], s.dot(n);
    before_ = 1.0 / before.norm();
    after_ = 1.0 / after.norm();
    stiffness_ = 2.0 * rigidity / (before.norm() + after.norm());
}

double SpaceHinge::energy(const Vectors& positions, const Vectors& directors) const {
    const Eigen::Vector3d u = before_ * edge(positions, 0), v = after_ * edge(positions, 1);
    const Eigen::Vector3d d = directors.row(vertex_[1]);
    const Eigen::Vector3d kink = v - rotation_(0, 0) * u - rotation_(1, 0) * d.cross(u);
    const double along = d.dot(kink);
    return 0.5 * stiffness_ * (kink.squaredNorm() - along * along);
}

void SpaceHinge::derivatives(const Vectors& positions, const Vectors& directors,
                             const Eigen::Matrix<double, 3, 2>& frame, bool exact, Force& force,
                             Stiffness& stiffness) const {
    const Eigen::Vector3d u = before_ * edge(positions, 0), v = after_ * edge(positions, 1);
    const Eigen::Vector3d d = directors.row(vertex_[1]);
    const Eigen::Matrix<double, 2, 3> flat = frame.transpose();
    const Eigen::Vector2d kink = flat * v - rotation_ * (flat * u);
    Eigen::Matrix<double, 2, kUnknowns> operation;
    operation.leftCols<3>() = before_ * rotation_ * flat;
    operation.middleCols<3>(6) = after_ * flat;
    operation.middleCols<3>(3) = -operation.leftCols<3>() - operation.middleCols<3>(6);
    operation.rightCols<2>() = d.dot(u) * rotation_ - d.dot(v) * Eigen::Matrix2d::Identity();
    force = stiffness_ * operation.transpose() * kink;
    stiffness = stiffness_ * operation.transpose() * operation;
    if (!exact)
        return;
    const Eigen::RowVector2d back = stiffness_ * before_ * (rotation_.transpose() * kink).transpose();
    const Eigen::RowVector2d ahead = stiffness_ * after_ * kink.transpose();
    Eigen::Matrix<double, 9, 2> mixed;
    mixed << -d * back, d * (back + ahead), -d * ahead;
    stiffness.topRightCorner<9, 2>() += mixed;
    stiffness.bottomLeftCorner<2, 9>() += mixed.transpose();
    // a director that turns by t sinks by t^2 / 2
    const Eigen::Vector2d s = flat * u, n = flat * v;
    const double cosine = rotation_(0, 0);
    const Eigen::Matrix2d squares =
        s * s.transpose() + n * n.transpose() - cosine * (s * n.transpose() + n * s.transpose());
    stiffness.bottomRightCorner<2, 2>() +=
        stiffness_ * (rotation_(1, 0) * d.dot(u.cross(v)) * Eigen::Matrix2d::Identity() - squares);
}

} // namespace film
