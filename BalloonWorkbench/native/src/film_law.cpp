// SPDX-License-Identifier: LGPL-2.1-or-later
#include "film_law.h"

namespace film {

FilmLaw::FilmLaw(const film_material& material)
    : poisson_(material.poisson_ratio), orthotropic_(material.orthotropic != 0),
      tension_field_(material.tension_field != 0),
      grain_{material.across, material.shear, material.poisson_ratio, material.grain_angle} {
    Grain grain = grain_;
    if (!orthotropic_) {
        grain = {1.0, 0.5 / (1.0 + poisson_), poisson_, 0.0};
    }
    stiffness_ = grain.turn().transpose() * grain.stiffness() * grain.turn();
}

MembraneResponse FilmLaw::response(const Eigen::Vector3d& strain) const {
    if (!tension_field_) {
        const Eigen::Vector3d stress = stiffness_ * strain;
        return {0.5 * stress.dot(strain), stress, stiffness_};
    }
    return orthotropic_ ? orthotropic_tension_field(strain, grain_) : tension_field(strain, poisson_);
}

double FilmLaw::energy(const Eigen::Vector3d& strain) const {
    if (tension_field_ && !orthotropic_) {
        return tension_field_energy(strain, poisson_);
    }
    return response(strain).energy;
}

} // namespace film
