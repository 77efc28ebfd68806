// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "blocks.h"
#include "dkt.h"
#include "film_law.h"
#include "symmetric_matrix.h"

namespace film {

using Vectors = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

struct State {
    Vectors positions;
    Vectors directors; // unit length
};

struct Energies {
    double membrane = 0.0, bending = 0.0, pressure = 0.0, load = 0.0, seam = 0.0;
    double total() const { return membrane + bending + pressure + load + seam; }
};

// Two unit vectors across each director.
struct Frames {
    Vectors first, second;
    explicit Frames(const Vectors& directors);
};

// The discrete film: energy, gradient and Hessian (Gauss-Newton in the bending part).
class Shell {
public:
    Shell(int vertices, const double* rest_positions, int triangles, const int32_t* triangle_corners,
          const uint8_t* fixed, const double* loads, const int32_t* tied, int hinges,
          const int32_t* seam_hinges, const double* hinge_rigidities, const film_material& material);

    int vertices() const { return static_cast<int>(vertex_area_.size()); }
    int count() const { return count_; }
    void set_membrane_stiffness(double stiffness) { material_.membrane_stiffness = stiffness; }

    Energies energies(const State& state) const;

    // Fills the gradient and the lower triangle of the Hessian in the free unknowns.
    void derivatives(const State& state, const Frames& frames, Eigen::VectorXd& gradient,
                     SymmetricMatrix& hessian) const;

    // An all-zero matrix with the pattern of the Hessian; the diagonal entry is the first of each column.
    const SymmetricMatrix& pattern() const { return pattern_; }

    // The unknowns of each vertex, at its place in the flat film.
    const Blocks& blocks() const { return blocks_; }

    // What a unit of shift adds to each diagonal entry.
    Eigen::VectorXd masses(double director_shift) const;

    // The state after a step in the free unknowns, directors put back on the sphere.
    State moved(const State& state, const Frames& frames, const Eigen::VectorXd& step, double length) const;

private:
    static constexpr int kFilmUnknowns = 15, kBandUnknowns = 6;

    struct Triangle {
        std::array<int, 3> corner;
        std::array<int, kFilmUnknowns> unknown; // x y z of the corners, then two turns of each; -1 when held
        Matrix32 shape;                         // gradients of the area coordinates
        double area;
        Matrix6 rotation_stiffness;
    };
    struct Hinge {
        std::array<int, 3> vertex;
        std::array<int, kBandUnknowns> unknown;
        Eigen::Matrix<double, 2, kBandUnknowns> kink; // of the edges around the middle vertex
        double stiffness;
    };

    Eigen::Matrix<double, 3, 2> deformation_gradient(const Triangle& triangle,
                                                     const Vectors& positions) const;
    void build_pattern();
    void add_film(const Triangle& triangle, const int* slot, const State& state, const Frames& frames,
                  Eigen::VectorXd& gradient, double* values) const;
    static Eigen::Matrix<double, kBandUnknowns, 1> band_positions(const Hinge& hinge,
                                                                  const Vectors& positions);
    void add_band(const Hinge& hinge, const int* slot, const Vectors& positions, Eigen::VectorXd& gradient,
                  double* values) const;

    film_material material_;
    FilmLaw law_;
    std::vector<Triangle> triangles_;
    std::vector<Hinge> hinges_;
    std::vector<double> vertex_area_;
    std::vector<std::array<int, 5>> number_; // of the unknowns of each vertex
    Vectors loads_;
    int count_ = 0;
    Blocks blocks_;
    SymmetricMatrix pattern_;
    std::vector<int> film_slots_, band_slots_; // where each lower element entry goes, -1 for none
};

} // namespace film
