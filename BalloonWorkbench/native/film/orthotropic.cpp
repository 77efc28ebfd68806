// SPDX-License-Identifier: LGPL-2.1-or-later
#include "orthotropic.h"

#include <algorithm>
#include <cmath>

namespace film {
namespace {

constexpr double kPi = 3.141592653589793238462643383280;

// Young's modulus in a direction, and its derivatives by the angle.
struct Modulus {
    double value, first, second;
};

Modulus modulus(double angle, const Grain& grain) {
    const double mixed = 1.0 / grain.shear - 2.0 * grain.poisson;
    const double c2 = std::cos(2.0 * angle), s2 = std::sin(2.0 * angle), c4 = c2 * c2 - s2 * s2;
    const double compliance =
        0.25 * ((1.0 + c2) * (1.0 + c2) + (1.0 - c2) * (1.0 - c2) / grain.across + mixed * s2 * s2);
    const double first = -(1.0 + c2) * s2 + (1.0 - c2) * s2 / grain.across + mixed * s2 * c2;
    const double second = -2.0 * (c2 + c4) + 2.0 * (c2 - c4) / grain.across + 2.0 * mixed * c4;
    const double square = compliance * compliance;
    return {1.0 / compliance, -first / square, 2.0 * first * first / (square * compliance) - second / square};
}

Eigen::Vector3d fibre(double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * c, s * s, c * s};
}

// Derivatives by the angle of E(a) e^2 / 2, its gradient by the strain and their mixed derivative.
struct Merit {
    double slope, curvature;
    Eigen::Vector3d stress, mixed;
};

Merit merit(double angle, const Eigen::Vector3d& strain, const Grain& grain) {
    const Modulus m = modulus(angle, grain);
    const double c = std::cos(angle), s = std::sin(angle);
    const Eigen::Vector3d along = fibre(angle), turned(-2.0 * c * s, 2.0 * c * s, c * c - s * s);
    const double e = along.dot(strain), de = turned.dot(strain);
    const double dde = -4.0 * e + 2.0 * (strain[0] + strain[1]);
    return {0.5 * m.first * e * e + m.value * e * de,
            0.5 * m.second * e * e + 2.0 * m.first * e * de + m.value * (de * de + e * dde),
            m.value * e * along, (m.first * e + m.value * de) * along + m.value * e * turned};
}

// The direction of tension of a wrinkled film.
double tension_direction(const Eigen::Vector3d& strain, const Grain& grain, const DirectionSearch& search) {
    const double longest = 0.5 * std::atan2(strain[2], strain[0] - strain[1]);
    double angle = longest, best = -1.0;
    for (int trial = -1; trial < search.directions; ++trial) { // the longest fibre is tried too
        const double at = trial < 0 ? longest : kPi * trial / search.directions;
        const double e = fibre(at).dot(strain);
        const double value = e > 0.0 ? modulus(at, grain).value * e * e : -1.0;
        if (value > best) {
            best = value;
            angle = at;
        }
    }
    const double most = 0.5 * kPi / search.directions;
    for (int step = 0; step < search.steps; ++step) {
        const Merit m = merit(angle, strain, grain);
        if (m.curvature < 0.0)
            angle += std::min(std::max(-m.slope / m.curvature, -most), most);
    }
    return angle;
}

} // namespace

Eigen::Matrix3d Grain::stiffness() const {
    const double scale = 1.0 / (1.0 - poisson * poisson * across), coupling = scale * poisson * across;
    Eigen::Matrix3d stiffness;
    stiffness << scale, coupling, 0.0, coupling, scale * across, 0.0, 0.0, 0.0, shear;
    return stiffness;
}

Eigen::Matrix3d Grain::rotation() const {
    const double c = std::cos(angle), s = std::sin(angle);
    Eigen::Matrix3d rotation;
    rotation << c * c, s * s, c * s, s * s, c * c, -c * s, -2 * c * s, 2 * c * s, c * c - s * s;
    return rotation;
}

MembraneResponse orthotropic_tension_field(const Eigen::Vector3d& strain, const Grain& grain,
                                           const DirectionSearch& search) {
    const Eigen::Matrix3d rotation = grain.rotation(), stiffness = grain.stiffness();
    const Eigen::Vector3d local = rotation * strain;
    Eigen::Vector3d stress = stiffness * local;
    Eigen::Matrix3d tangent = stiffness;
    const double smaller =
        0.5 * (stress[0] + stress[1]) - std::hypot(0.5 * (stress[0] - stress[1]), stress[2]);
    const double longest =
        0.5 * (local[0] + local[1]) + std::hypot(0.5 * (local[0] - local[1]), 0.5 * local[2]);
    if (!(smaller > 0.0) && longest > 0.0) {
        const double angle = tension_direction(local, grain, search);
        const Merit m = merit(angle, local, grain);
        const Eigen::Vector3d along = fibre(angle);
        stress = m.stress;
        tangent = modulus(angle, grain).value * along * along.transpose()
                  - m.mixed * m.mixed.transpose() / std::min(m.curvature, -1e-300);
    } else if (!(smaller > 0.0)) {
        stress.setZero();
        tangent.setZero();
    }
    return {0.5 * stress.dot(local), rotation.transpose() * stress,
            rotation.transpose() * tangent * rotation};
}

} // namespace film
