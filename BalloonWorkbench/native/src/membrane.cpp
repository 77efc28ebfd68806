// SPDX-License-Identifier: LGPL-2.1-or-later
#include "membrane.h"

#include <cmath>

namespace film {
namespace {

struct Principal {
    double mean, radius;
    double major() const { return mean + radius; }
    double minor() const { return mean - radius; }
};

Principal principal(const Eigen::Vector3d& strain) {
    return {0.5 * (strain[0] + strain[1]), std::hypot(0.5 * (strain[0] - strain[1]), 0.5 * strain[2])};
}

Eigen::Vector3d taut_stress(const Eigen::Vector3d& strain, double nu) {
    const double scale = 1.0 / (1.0 - nu * nu);
    return {scale * (strain[0] + nu * strain[1]), scale * (strain[1] + nu * strain[0]),
            0.5 / (1.0 + nu) * strain[2]};
}

} // namespace

MembraneResponse tension_field(const Eigen::Vector3d& strain, double nu) {
    const Principal e = principal(strain);
    MembraneResponse response;
    if (e.minor() + nu * e.major() > 0.0) {
        const double scale = 1.0 / (1.0 - nu * nu);
        response.stress = taut_stress(strain, nu);
        response.tangent << scale, scale * nu, 0.0, scale * nu, scale, 0.0, 0.0, 0.0, 0.5 / (1.0 + nu);
    } else if (e.major() > 0.0) {
        const double angle = 0.5 * std::atan2(0.5 * strain[2], 0.5 * (strain[0] - strain[1]));
        const double c = std::cos(angle), s = std::sin(angle);
        const Eigen::Vector3d along(c * c, s * s, c * s);                   // E1 = along . strain
        const Eigen::Vector3d across(-c * s, c * s, 0.5 * (c * c - s * s)); // shear that turns the wrinkles
        const double turning = 2.0 * e.major() / (e.major() - e.minor());
        response.stress = e.major() * along;
        response.tangent = along * along.transpose() + turning * across * across.transpose();
    } else {
        response.stress.setZero();
        response.tangent.setZero();
    }
    response.energy = 0.5 * response.stress.dot(strain);
    return response;
}

double tension_field_energy(const Eigen::Vector3d& strain, double nu) {
    const Principal e = principal(strain);
    if (e.minor() + nu * e.major() > 0.0)
        return 0.5 * taut_stress(strain, nu).dot(strain);
    return e.major() > 0.0 ? 0.5 * e.major() * e.major() : 0.0;
}

} // namespace film
