// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cholesky/block_matrix.h"
#include "element.h"
#include "space_band.h"

namespace film {

using cholesky::BlockMatrix;

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

// The discrete film: energy, gradient and Hessian (Gauss-Newton in the bending part, unless it is exact).
class Shell {
public:
    Shell(int vertices, const double* rest_positions, int triangles, const int32_t* triangle_corners,
          const uint8_t* fixed, const double* loads, const int32_t* tied, int hinges,
          const int32_t* seam_hinges, const double* hinge_rigidities, const film_material& material,
          const film_constants& constants);

    int vertices() const { return static_cast<int>(number_.size()); }
    int count() const { return static_cast<int>(blocks_.block_of_unknown.size()); }
    bool held(int vertex, int unknown) const { return number_[vertex][unknown] < 0; }
    void set_membrane_stiffness(double stiffness) { scales_.membrane_stiffness = stiffness; }

    // Adds the stiffness of so much tension in all directions to the Hessian.
    void set_tension(double tension) { scales_.tension = tension; }

    // Adds so much of the stiffness of taut film to the Hessian, whatever state it is in.
    void set_slack_stiffness(double part) { scales_.slack_stiffness = part; }

    // Whether the seams do not stay in one plane.
    bool in_space() const { return in_space_; }

    // Adds the second derivatives of the rotations to the Hessian, too.
    void set_exact(bool exact) { scales_.exact = exact; }

    Energies energies(const State& state) const;

    // Fills the gradient and the Hessian in the free unknowns.
    void derivatives(const State& state, const Frames& frames, Eigen::VectorXd& gradient,
                     BlockMatrix& hessian) const;

    // An all-zero Hessian.
    BlockMatrix hessian() const;

    // The unknowns of each vertex, at its place in the flat film.
    const cholesky::Blocks& blocks() const { return blocks_; }

    // What a unit of shift adds to each diagonal entry.
    Eigen::VectorXd masses(double director_shift) const;

    // The state after a step in the free unknowns, directors put back on the sphere.
    State moved(const State& state, const Frames& frames, const Eigen::VectorXd& step, double length) const;

    // Numbers (vertices, 5, fields) of the unknowns of each vertex, summed in the free ones: a column a
    // field.
    Eigen::MatrixXd gathered(const double* numbers, int fields) const;

    // The moves (vertices, 3, fields) of the positions that free unknowns stand for.
    void spread(const Eigen::MatrixXd& columns, double* moves) const;

private:
    struct Hinge {
        std::array<int, 3> vertex;
        Eigen::Matrix<double, 2, 6> kink; // of the edges around the middle vertex
        double stiffness;
    };

    void number_unknowns(const uint8_t* fixed, const int32_t* tied);
    Hinge hinge(const int32_t* vertices, double rigidity) const;
    Eigen::Vector2d rest(int vertex) const { return {blocks_.points[vertex][0], blocks_.points[vertex][1]}; }
    // Whether all five unknowns of a vertex are free and its own.
    bool is_full_block(int vertex) const;
    int gather(size_t first_triangle, const State& state, FourTriangles& film) const;
    void scatter(size_t triangle, int lane, const FourElements& elements, Eigen::VectorXd& gradient,
                 BlockMatrix& hessian) const;
    void add_band(const Hinge& hinge, const Vectors& positions, Eigen::VectorXd& gradient,
                  BlockMatrix& hessian) const;
    void add_space_band(const SpaceHinge& hinge, const State& state, const Frames& frames,
                        Eigen::VectorXd& gradient, BlockMatrix& hessian) const;

    FilmScales scales_;
    bool in_space_;
    FilmLaw law_;
    const FilmKernels& kernels_;
    std::vector<std::array<int, 3>> triangles_; // their corners
    std::vector<Hinge> hinges_;
    std::vector<SpaceHinge> space_hinges_;
    std::vector<std::array<int, 5>> number_; // of the unknowns of each vertex, -1 where held
    Vectors loads_;                          // none, or one a vertex
    cholesky::Blocks blocks_;
};

} // namespace film
