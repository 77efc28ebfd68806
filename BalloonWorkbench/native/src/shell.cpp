// SPDX-License-Identifier: LGPL-2.1-or-later
#include "shell.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace film {
namespace {

Eigen::Vector3d green_strain(const Matrix32& f) {
    return {0.5 * (f.col(0).squaredNorm() - 1.0), 0.5 * (f.col(1).squaredNorm() - 1.0),
            f.col(0).dot(f.col(1))};
}

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
    Eigen::Matrix3d m;
    m << 0.0, -v[2], v[1], v[2], 0.0, -v[0], -v[1], v[0], 0.0;
    return m;
}

// Slots of the lower triangle of an element matrix inside a compressed lower-triangular pattern.
template <size_t N>
void find_slots(const std::array<int, N>& unknown, const SymmetricMatrix& pattern, std::vector<int>& slots) {
    for (size_t i = 0; i < N; ++i) {
        for (size_t j = 0; j <= i; ++j) {
            int slot = -1;
            if (unknown[i] >= 0 && unknown[j] >= 0) {
                const int column = std::min(unknown[i], unknown[j]), row = std::max(unknown[i], unknown[j]);
                const int* begin = pattern.innerIndexPtr() + pattern.outerIndexPtr()[column];
                const int* end = pattern.innerIndexPtr() + pattern.outerIndexPtr()[column + 1];
                slot = static_cast<int>(std::lower_bound(begin, end, row) - pattern.innerIndexPtr());
            }
            slots.push_back(slot);
        }
    }
}

// Adds an element's forces and the lower triangle of its stiffness.
template <int N>
void scatter(const std::array<int, N>& unknown, const int* slot, const Eigen::Matrix<double, N, 1>& force,
             const Eigen::Matrix<double, N, N>& stiffness, Eigen::VectorXd& gradient, double* values) {
    for (int i = 0; i < N; ++i) {
        if (unknown[i] >= 0)
            gradient[unknown[i]] += force[i];
        for (int j = 0; j <= i; ++j, ++slot) {
            if (*slot >= 0)
                values[*slot] += stiffness(i, j);
        }
    }
}

} // namespace

Frames::Frames(const Vectors& directors) : first(directors.rows(), 3), second(directors.rows(), 3) {
    for (Eigen::Index i = 0; i < directors.rows(); ++i) {
        const Eigen::Vector3d d = directors.row(i);
        Eigen::Index smallest = 0;
        d.cwiseAbs().minCoeff(&smallest);
        const Eigen::Vector3d across = d.cross(Eigen::Vector3d::Unit(smallest)).normalized();
        first.row(i) = across;
        second.row(i) = d.cross(across);
    }
}

Shell::Shell(int vertices, const double* rest_positions, int triangles, const int32_t* triangle_corners,
             const uint8_t* fixed, const double* loads, const int32_t* tied, int hinges,
             const int32_t* seam_hinges, const double* hinge_rigidities, const film_material& material)
    : material_(material), law_(material), vertex_area_(vertices, 0.0), number_(vertices),
      loads_(Vectors::Zero(vertices, 3)) {
    if (loads != nullptr)
        loads_ = Eigen::Map<const Vectors>(loads, vertices, 3);
    for (int vertex = 0; vertex < vertices; ++vertex) {
        const int master = tied != nullptr ? tied[vertex] : vertex;
        for (int k = 0; k < 5; ++k) {
            if (k < 3 && master != vertex) {
                number_[vertex][k] = number_[master][k];
            } else if (fixed[5 * vertex + k]) {
                number_[vertex][k] = -1;
            } else {
                number_[vertex][k] = count_++;
                blocks_.block_of_unknown.push_back(vertex);
            }
        }
        blocks_.points.push_back({rest_positions[2 * vertex], rest_positions[2 * vertex + 1]});
    }
    const auto rest = [rest_positions](int vertex) {
        return Eigen::Vector2d(rest_positions[2 * vertex], rest_positions[2 * vertex + 1]);
    };
    triangles_.resize(triangles);
    for (int t = 0; t < triangles; ++t) {
        Triangle& triangle = triangles_[t];
        Matrix32 corners;
        for (int a = 0; a < 3; ++a) {
            const int vertex = triangle_corners[3 * t + a];
            triangle.corner[a] = vertex;
            corners.row(a) = rest(vertex);
            for (int k = 0; k < 3; ++k)
                triangle.unknown[3 * a + k] = number_[vertex][k];
            for (int k = 0; k < 2; ++k)
                triangle.unknown[9 + 2 * a + k] = number_[vertex][3 + k];
        }
        triangle.shape = area_coordinate_gradients(corners, triangle.area);
        triangle.rotation_stiffness = rotation_stiffness(corners, material.poisson_ratio);
        for (int vertex : triangle.corner)
            vertex_area_[vertex] += triangle.area / 3.0;
    }
    if (std::find(vertex_area_.begin(), vertex_area_.end(), 0.0) != vertex_area_.end())
        throw std::invalid_argument("a vertex belongs to no triangle");
    hinges_.resize(hinges);
    for (size_t h = 0; h < hinges_.size(); ++h) {
        Hinge& hinge = hinges_[h];
        for (int a = 0; a < 3; ++a) {
            hinge.vertex[a] = seam_hinges[3 * h + a];
            for (int k = 0; k < 2; ++k)
                hinge.unknown[2 * a + k] = number_[hinge.vertex[a]][k];
        }
        const Eigen::Vector2d before = rest(hinge.vertex[1]) - rest(hinge.vertex[0]);
        const Eigen::Vector2d after = rest(hinge.vertex[2]) - rest(hinge.vertex[1]);
        const Eigen::Vector2d s = before.normalized(), n = after.normalized();
        Eigen::Matrix2d turn; // rotation by the turning angle at rest
        turn << s.dot(n), s[1] * n[0] - s[0] * n[1], s[0] * n[1] - s[1] * n[0], s.dot(n);
        turn /= before.norm();
        const Eigen::Matrix2d straight = Eigen::Matrix2d::Identity() / after.norm();
        hinge.kink << turn, -turn - straight, straight;
        hinge.stiffness = 2.0 * hinge_rigidities[h] / (before.norm() + after.norm());
    }
    build_pattern();
}

void Shell::build_pattern() {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(triangles_.size() * 120 + hinges_.size() * 21);
    const auto add = [&entries](const auto& unknown) {
        for (int row : unknown) {
            for (int column : unknown) {
                if (row >= column && column >= 0)
                    entries.emplace_back(row, column, 0.0);
            }
        }
    };
    for (const Triangle& triangle : triangles_)
        add(triangle.unknown);
    for (const Hinge& hinge : hinges_)
        add(hinge.unknown);
    pattern_.resize(count_, count_);
    pattern_.setFromTriplets(entries.begin(), entries.end());
    for (const Triangle& triangle : triangles_)
        find_slots(triangle.unknown, pattern_, film_slots_);
    for (const Hinge& hinge : hinges_)
        find_slots(hinge.unknown, pattern_, band_slots_);
}

Matrix32 Shell::deformation_gradient(const Triangle& triangle, const Vectors& positions) const {
    Eigen::Matrix3d corners;
    for (int a = 0; a < 3; ++a)
        corners.col(a) = positions.row(triangle.corner[a]);
    return corners * triangle.shape;
}

Energies Shell::energies(const State& state) const {
    Energies parts;
    double volume = 0.0;
    for (const Triangle& triangle : triangles_) {
        const Matrix32 f = deformation_gradient(triangle, state.positions);
        parts.membrane += triangle.area * law_.energy(green_strain(f));
        Eigen::Matrix<double, 6, 1> rotation;
        for (int a = 0; a < 3; ++a) {
            rotation.segment<2>(2 * a) = f.transpose() * state.directors.row(triangle.corner[a]).transpose();
        }
        parts.bending += 0.5 * rotation.dot(triangle.rotation_stiffness * rotation);
        const Eigen::Vector3d a = state.positions.row(triangle.corner[0]),
                              b = state.positions.row(triangle.corner[1]),
                              c = state.positions.row(triangle.corner[2]);
        volume += a.dot(b.cross(c)) / 6.0;
    }
    parts.membrane *= material_.membrane_stiffness;
    parts.bending *= material_.flexural_rigidity;
    parts.pressure = -material_.pressure * volume;
    parts.load = -loads_.cwiseProduct(state.positions).sum();
    for (const Hinge& hinge : hinges_) {
        parts.seam +=
            0.5 * hinge.stiffness * (hinge.kink * band_positions(hinge, state.positions)).squaredNorm();
    }
    return parts;
}

void Shell::derivatives(const State& state, const Frames& frames, Eigen::VectorXd& gradient,
                        SymmetricMatrix& hessian) const {
    gradient.setZero(count_);
    double* values = hessian.valuePtr();
    std::fill(values, values + hessian.nonZeros(), 0.0);
    constexpr int film_size = kFilmUnknowns * (kFilmUnknowns + 1) / 2,
                  band_size = kBandUnknowns * (kBandUnknowns + 1) / 2;
    for (size_t t = 0; t < triangles_.size(); ++t) {
        add_film(triangles_[t], &film_slots_[t * film_size], state, frames, gradient, values);
    }
    for (size_t h = 0; h < hinges_.size(); ++h) {
        add_band(hinges_[h], &band_slots_[h * band_size], state.positions, gradient, values);
    }
    for (int vertex = 0; vertex < vertices(); ++vertex) {
        for (int k = 0; k < 3; ++k) {
            if (number_[vertex][k] >= 0)
                gradient[number_[vertex][k]] -= loads_(vertex, k);
        }
    }
}

void Shell::add_film(const Triangle& triangle, const int* slot, const State& state, const Frames& frames,
                     Eigen::VectorXd& gradient, double* values) const {
    const Matrix32 f = deformation_gradient(triangle, state.positions);
    const Matrix32& g = triangle.shape;
    Eigen::Matrix<double, 15, 1> force = Eigen::Matrix<double, 15, 1>::Zero();
    Eigen::Matrix<double, 15, 15> stiffness = Eigen::Matrix<double, 15, 15>::Zero();

    // membrane: material and geometric stiffness
    const MembraneResponse membrane = law_.response(green_strain(f));
    const double scale = material_.membrane_stiffness * triangle.area;
    Eigen::Matrix<double, 3, 9> strain_operator;
    for (int a = 0; a < 3; ++a) {
        strain_operator.block<1, 3>(0, 3 * a) = g(a, 0) * f.col(0).transpose();
        strain_operator.block<1, 3>(1, 3 * a) = g(a, 1) * f.col(1).transpose();
        strain_operator.block<1, 3>(2, 3 * a) =
            g(a, 0) * f.col(1).transpose() + g(a, 1) * f.col(0).transpose();
    }
    force.head<9>() = scale * strain_operator.transpose() * membrane.stress;
    stiffness.topLeftCorner<9, 9>() =
        scale * strain_operator.transpose() * membrane.tangent * strain_operator;
    Eigen::Matrix2d stress;
    stress << membrane.stress[0], membrane.stress[2], membrane.stress[2], membrane.stress[1];
    const Eigen::Matrix3d geometric = scale * g * stress * g.transpose();
    for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b)
            stiffness.block<3, 3>(3 * a, 3 * b).diagonal().array() += geometric(a, b);
    }

    // bending: rotations of the directors against the triangle
    Eigen::Matrix<double, 6, 1> rotation;
    Eigen::Matrix<double, 6, 15> jacobian = Eigen::Matrix<double, 6, 15>::Zero();
    for (int c = 0; c < 3; ++c) {
        const int vertex = triangle.corner[c];
        const Eigen::RowVector3d d = state.directors.row(vertex);
        rotation.segment<2>(2 * c) = (d * f).transpose();
        for (int k = 0; k < 2; ++k) {
            for (int a = 0; a < 3; ++a)
                jacobian.block<1, 3>(2 * c + k, 3 * a) = g(a, k) * d;
            jacobian(2 * c + k, 9 + 2 * c) = frames.first.row(vertex).dot(f.col(k));
            jacobian(2 * c + k, 10 + 2 * c) = frames.second.row(vertex).dot(f.col(k));
        }
    }
    const Eigen::Matrix<double, 6, 15> weighted =
        material_.flexural_rigidity * triangle.rotation_stiffness * jacobian;
    force += weighted.transpose() * rotation;
    stiffness.noalias() += jacobian.transpose() * weighted;

    // pressure: - p times the volume under the triangle
    const double nodal = material_.pressure / 6.0;
    for (int a = 0; a < 3; ++a) {
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        const Eigen::Vector3d at_b = state.positions.row(triangle.corner[b]),
                              at_c = state.positions.row(triangle.corner[c]);
        force.segment<3>(3 * a) -= nodal * at_b.cross(at_c);
        stiffness.block<3, 3>(3 * a, 3 * b) += nodal * cross_matrix(at_c);
        stiffness.block<3, 3>(3 * a, 3 * c) -= nodal * cross_matrix(at_b);
    }
    scatter<kFilmUnknowns>(triangle.unknown, slot, force, stiffness, gradient, values);
}

Eigen::Matrix<double, Shell::kBandUnknowns, 1> Shell::band_positions(const Hinge& hinge,
                                                                     const Vectors& positions) {
    Eigen::Matrix<double, kBandUnknowns, 1> flat;
    for (int a = 0; a < 3; ++a)
        flat.segment<2>(2 * a) = positions.row(hinge.vertex[a]).head<2>();
    return flat;
}

void Shell::add_band(const Hinge& hinge, const int* slot, const Vectors& positions, Eigen::VectorXd& gradient,
                     double* values) const {
    const Eigen::Matrix<double, 6, 6> stiffness = hinge.stiffness * hinge.kink.transpose() * hinge.kink;
    const Eigen::Matrix<double, 6, 1> force = stiffness * band_positions(hinge, positions);
    scatter<kBandUnknowns>(hinge.unknown, slot, force, stiffness, gradient, values);
}

Eigen::VectorXd Shell::masses(double director_shift) const {
    Eigen::VectorXd mass = Eigen::VectorXd::Zero(count_);
    for (int vertex = 0; vertex < vertices(); ++vertex) {
        for (int k = 0; k < 5; ++k) {
            if (number_[vertex][k] < 0)
                continue;
            mass[number_[vertex][k]] +=
                k < 3 ? vertex_area_[vertex] : director_shift * material_.flexural_rigidity;
        }
    }
    return mass;
}

State Shell::moved(const State& state, const Frames& frames, const Eigen::VectorXd& step,
                   double length) const {
    State next = state;
    for (int vertex = 0; vertex < vertices(); ++vertex) {
        const std::array<int, 5>& number = number_[vertex];
        const auto part = [&](int k) { return number[k] >= 0 ? length * step[number[k]] : 0.0; };
        next.positions.row(vertex) += Eigen::RowVector3d(part(0), part(1), part(2));
        next.directors.row(vertex) +=
            part(3) * frames.first.row(vertex) + part(4) * frames.second.row(vertex);
        next.directors.row(vertex).normalize();
    }
    return next;
}

} // namespace film
