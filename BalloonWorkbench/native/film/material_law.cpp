// SPDX-License-Identifier: LGPL-2.1-or-later
#include "material_law.h"

namespace film {

FilmLaw::FilmLaw(const film_material& material, const film_constants& constants)
    : poisson_(material.poisson_ratio), orthotropic_(material.orthotropic != 0),
      tension_field_(material.tension_field != 0),
      grain_{material.across, material.shear, material.poisson_ratio, material.grain_angle},
      search_{constants.directions, constants.direction_steps} {
    Grain grain = grain_;
    if (!orthotropic_) {
        grain = {1.0, 0.5 / (1.0 + poisson_), poisson_, 0.0};
    }
    stiffness_ = grain.rotation().transpose() * grain.stiffness() * grain.rotation();
}

MembraneResponse FilmLaw::response(const Eigen::Vector3d& strain) const {
    if (tension_field_)
        return orthotropic_tension_field(strain, grain_, search_);
    const Eigen::Vector3d stress = stiffness_ * strain;
    return {0.5 * stress.dot(strain), stress, stiffness_};
}

void FilmLaw::lane_by_lane(const Vec4 (&strain)[3], FourResponses& responses) const {
    for (int lane = 0; lane < 4; ++lane) {
        const MembraneResponse one = response({strain[0][lane], strain[1][lane], strain[2][lane]});
        responses.energy[lane] = one.energy;
        for (int i = 0; i < 3; ++i) {
            responses.stress[i][lane] = one.stress[i];
            for (int j = 0; j < 3; ++j)
                responses.tangent[i][j][lane] = one.tangent(i, j);
        }
    }
}

} // namespace film
