// SPDX-License-Identifier: LGPL-2.1-or-later
#include "shell.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace film {
namespace {

constexpr int kLanes = 4;

Eigen::Matrix<double, 6, 1> flat_positions(const std::array<int, 3>& vertex, const Vectors& positions) {
    Eigen::Matrix<double, 6, 1> flat;
    for (int a = 0; a < 3; ++a)
        flat.segment<2>(2 * a) = positions.row(vertex[a]).head<2>();
    return flat;
}

// Adds the numbers of a whole block, or what is not above its diagonal.
template <bool Lower, typename Number>
void add_block(int row_block, int column_block, BlockMatrix& hessian, const Number& number) {
    double* const begin = hessian.at(hessian.begin(row_block, column_block));
    for (int j = 0; j < 5; ++j) {
        double* const column = begin + hessian.offset(column_block, 0, j);
        for (int i = Lower ? j : 0; i < 5; ++i)
            column[i] += number(i, j);
    }
}

// Adds the numbers of a block one by one, of unknowns that are held none.
void add_entries(const std::array<int, 5>& rows, const std::array<int, 5>& columns, bool on_diagonal,
                 const Vec4 (&block)[5][5], int lane, BlockMatrix& hessian) {
    for (int i = 0; i < 5; ++i) {
        for (int j = 0; j < (on_diagonal ? i + 1 : 5); ++j) {
            if (rows[i] >= 0 && columns[j] >= 0) {
                const bool twice = rows[i] == columns[j] && !on_diagonal; // both vertices share a position
                hessian.add(rows[i], columns[j], (twice ? 2.0 : 1.0) * block[i][j][lane]);
            }
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
             const int32_t* seam_hinges, const double* hinge_rigidities, const film_material& material,
             const film_constants& constants)
    : scales_{material.membrane_stiffness, material.flexural_rigidity, material.poisson_ratio,
              material.pressure, material.gradient},
      in_space_(material.in_space != 0), law_(material, constants), kernels_(film_kernels()),
      triangles_(triangles), number_(vertices) {
    if (loads != nullptr)
        loads_ = Eigen::Map<const Vectors>(loads, vertices, 3);
    for (int vertex = 0; vertex < vertices; ++vertex)
        blocks_.points.push_back({rest_positions[2 * vertex], rest_positions[2 * vertex + 1]});
    number_unknowns(fixed, tied);
    std::vector<char> used(vertices, 0);
    for (int t = 0; t < triangles; ++t) {
        for (int a = 0; a < 3; ++a) {
            triangles_[t][a] = triangle_corners[3 * t + a];
            used[triangles_[t][a]] = 1;
        }
    }
    if (std::find(used.begin(), used.end(), 0) != used.end())
        throw std::invalid_argument("a vertex belongs to no triangle");
    // neighbours follow each other: what they add to is then still in cache
    std::stable_sort(triangles_.begin(), triangles_.end(), [](const auto& a, const auto& b) {
        return *std::min_element(a.begin(), a.end()) < *std::min_element(b.begin(), b.end());
    });
    for (int h = 0; h < hinges; ++h) {
        const int32_t* const vertex = seam_hinges + 3 * h;
        if (in_space_)
            space_hinges_.emplace_back(
                std::array<int, 3>{vertex[0], vertex[1], vertex[2]},
                std::array<Eigen::Vector2d, 3>{rest(vertex[0]), rest(vertex[1]), rest(vertex[2])},
                hinge_rigidities[h]);
        else
            hinges_.push_back(hinge(vertex, hinge_rigidities[h]));
    }
}

void Shell::number_unknowns(const uint8_t* fixed, const int32_t* tied) {
    for (int vertex = 0; vertex < vertices(); ++vertex) {
        const int master = tied != nullptr ? tied[vertex] : vertex;
        for (int k = 0; k < 5; ++k) {
            if (k < 3 && master != vertex) {
                number_[vertex][k] = number_[master][k];
            } else if (fixed[5 * vertex + k]) {
                number_[vertex][k] = -1;
            } else {
                number_[vertex][k] = count();
                blocks_.block_of_unknown.push_back(vertex);
            }
        }
    }
}

Shell::Hinge Shell::hinge(const int32_t* vertices, double rigidity) const {
    Hinge hinge{{vertices[0], vertices[1], vertices[2]}, {}, 0.0};
    const Eigen::Vector2d before = rest(vertices[1]) - rest(vertices[0]);
    const Eigen::Vector2d after = rest(vertices[2]) - rest(vertices[1]);
    const Eigen::Vector2d s = before.normalized(), n = after.normalized();
    Eigen::Matrix2d turn; // rotation by the turning angle at rest
    turn << s.dot(n), s[1] * n[0] - s[0] * n[1], s[0] * n[1] - s[1] * n[0], s.dot(n);
    turn /= before.norm();
    const Eigen::Matrix2d straight = Eigen::Matrix2d::Identity() / after.norm();
    hinge.kink << turn, -turn - straight, straight;
    hinge.stiffness = 2.0 * rigidity / (before.norm() + after.norm());
    return hinge;
}

BlockMatrix Shell::hessian() const {
    std::vector<std::pair<int, int>> joined;
    joined.reserve(3 * (triangles_.size() + hinges_.size() + space_hinges_.size()));
    const auto join = [&](const std::array<int, 3>& vertex) {
        std::array<int, 6> blocks; // that hold unknowns of these vertices
        int count = 0;
        for (int a = 0; a < 3; ++a) {
            blocks[count++] = vertex[a];
            for (int k = 0; k < 3; ++k) {
                const int number = number_[vertex[a]][k];
                if (number >= 0 && blocks_.block_of_unknown[number] != vertex[a]) {
                    blocks[count++] = blocks_.block_of_unknown[number];
                    break;
                }
            }
        }
        for (int a = 0; a < count; ++a) {
            for (int b = 0; b < a; ++b)
                joined.emplace_back(blocks[a], blocks[b]);
        }
    };
    for (const std::array<int, 3>& corners : triangles_)
        join(corners);
    for (const Hinge& hinge : hinges_)
        join(hinge.vertex);
    for (const SpaceHinge& hinge : space_hinges_)
        join(hinge.vertices());
    return BlockMatrix(blocks_.block_of_unknown, vertices(), joined);
}

// Four triangles, or what is left; how many. Beyond them the last one is repeated.
int Shell::gather(size_t first_triangle, const State& state, FourTriangles& film) const {
    const int count = static_cast<int>(std::min<size_t>(kLanes, triangles_.size() - first_triangle));
    for (int lane = 0; lane < kLanes; ++lane) {
        for (int a = 0; a < 3; ++a) {
            const int vertex = triangles_[first_triangle + std::min(lane, count - 1)][a];
            for (int i = 0; i < 2; ++i)
                film.rest[a][i][lane] = blocks_.points[vertex][i];
            for (int i = 0; i < 3; ++i) {
                film.position[a][i][lane] = state.positions(vertex, i);
                film.director[a][i][lane] = state.directors(vertex, i);
            }
        }
    }
    return count;
}

Energies Shell::energies(const State& state) const {
    Energies parts;
    double volume = 0.0, moment = 0.0;
    FourTriangles film;
    FourEnergies four;
    for (size_t first = 0; first < triangles_.size(); first += kLanes) {
        const int count = gather(first, state, film);
        kernels_.energies(film, law_, scales_.poisson_ratio, four);
        for (int lane = 0; lane < count; ++lane) {
            parts.membrane += four.membrane[lane];
            parts.bending += four.bending[lane];
            volume += four.volume[lane];
            moment += four.moment[lane];
        }
    }
    parts.membrane *= scales_.membrane_stiffness;
    parts.bending *= scales_.flexural_rigidity;
    parts.pressure = -scales_.pressure * volume;
    if (scales_.gradient != 0.0)
        parts.pressure -= scales_.gradient * moment;
    if (loads_.size() != 0)
        parts.load = -loads_.cwiseProduct(state.positions).sum();
    for (const Hinge& hinge : hinges_) {
        const Eigen::Vector2d kink = hinge.kink * flat_positions(hinge.vertex, state.positions);
        parts.seam += 0.5 * hinge.stiffness * kink.squaredNorm();
    }
    for (const SpaceHinge& hinge : space_hinges_)
        parts.seam += hinge.energy(state.positions, state.directors);
    return parts;
}

void Shell::derivatives(const State& state, const Frames& frames, Eigen::VectorXd& gradient,
                        BlockMatrix& hessian) const {
    gradient.setZero(count());
    hessian.clear();
    FourTriangles film;
    FourElements elements;
    for (size_t first = 0; first < triangles_.size(); first += kLanes) {
        const int count = gather(first, state, film);
        for (int lane = 0; lane < kLanes; ++lane) {
            for (int a = 0; a < 3; ++a) {
                const int vertex = triangles_[first + std::min(lane, count - 1)][a];
                for (int i = 0; i < 3; ++i) {
                    film.frame[a][0][i][lane] = frames.first(vertex, i);
                    film.frame[a][1][i][lane] = frames.second(vertex, i);
                }
            }
        }
        kernels_.derivatives(film, law_, scales_, elements);
        for (int lane = 0; lane < count; ++lane)
            scatter(first + lane, lane, elements, gradient, hessian);
    }
    for (const Hinge& hinge : hinges_)
        add_band(hinge, state.positions, gradient, hessian);
    for (const SpaceHinge& hinge : space_hinges_)
        add_space_band(hinge, state, frames, gradient, hessian);
    for (int vertex = 0; loads_.size() != 0 && vertex < vertices(); ++vertex) {
        for (int k = 0; k < 3; ++k) {
            if (number_[vertex][k] >= 0)
                gradient[number_[vertex][k]] -= loads_(vertex, k);
        }
    }
}

bool Shell::is_full_block(int vertex) const {
    const std::array<int, 5>& number = number_[vertex];
    return number[0] >= 0 && number[4] == number[0] + 4 && blocks_.block_of_unknown[number[0]] == vertex;
}

void Shell::scatter(size_t triangle, int lane, const FourElements& elements, Eigen::VectorXd& gradient,
                    BlockMatrix& hessian) const {
    const std::array<int, 3>& corner = triangles_[triangle];
    for (int a = 0; a < 3; ++a) {
        for (int k = 0; k < 5; ++k) {
            const int number = number_[corner[a]][k];
            if (number >= 0)
                gradient[number] += elements.force[a][k][lane];
        }
    }
    for (int pair = 0; pair < 6; ++pair) {
        const int a = corner[FourElements::kPairs[pair][0]], b = corner[FourElements::kPairs[pair][1]];
        const Vec4(&block)[5][5] = elements.stiffness[pair];
        const bool on_diagonal = pair < 3;
        if (is_full_block(a) && is_full_block(b) && (a == b) == on_diagonal) {
            if (on_diagonal)
                add_block<true>(a, a, hessian, [&](int i, int j) { return block[i][j][lane]; });
            else if (a > b)
                add_block<false>(a, b, hessian, [&](int i, int j) { return block[i][j][lane]; });
            else
                add_block<false>(b, a, hessian, [&](int i, int j) { return block[j][i][lane]; });
            continue;
        }
        add_entries(number_[a], number_[b], on_diagonal, block, lane, hessian);
    }
}

void Shell::add_band(const Hinge& hinge, const Vectors& positions, Eigen::VectorXd& gradient,
                     BlockMatrix& hessian) const {
    const Eigen::Matrix<double, 6, 6> stiffness = hinge.stiffness * hinge.kink.transpose() * hinge.kink;
    const Eigen::Matrix<double, 6, 1> force = stiffness * flat_positions(hinge.vertex, positions);
    for (int i = 0; i < 6; ++i) {
        const int row = number_[hinge.vertex[i / 2]][i % 2];
        if (row < 0)
            continue;
        gradient[row] += force[i];
        for (int j = 0; j <= i; ++j) {
            const int column = number_[hinge.vertex[j / 2]][j % 2];
            if (column >= 0)
                hessian.add(row, column, stiffness(i, j));
        }
    }
}

void Shell::add_space_band(const SpaceHinge& hinge, const State& state, const Frames& frames,
                           Eigen::VectorXd& gradient, BlockMatrix& hessian) const {
    const std::array<int, 3>& vertex = hinge.vertices();
    std::array<int, SpaceHinge::kUnknowns> number;
    for (int a = 0; a < 3; ++a)
        std::copy_n(number_[vertex[a]].begin(), 3, number.begin() + 3 * a);
    std::copy_n(number_[vertex[1]].begin() + 3, 2, number.begin() + 9);
    Eigen::Matrix<double, 3, 2> frame;
    frame << frames.first.row(vertex[1]).transpose(), frames.second.row(vertex[1]).transpose();
    SpaceHinge::Force force;
    SpaceHinge::Stiffness stiffness;
    hinge.derivatives(state.positions, state.directors, frame, scales_.exact, force, stiffness);
    for (int i = 0; i < SpaceHinge::kUnknowns; ++i) {
        if (number[i] < 0)
            continue;
        gradient[number[i]] += force[i];
        for (int j = 0; j <= i; ++j) {
            if (number[j] < 0)
                continue;
            const bool twice = i != j && number[i] == number[j]; // two vertices share a position
            hessian.add(number[i], number[j], (twice ? 2.0 : 1.0) * stiffness(i, j));
        }
    }
}

Eigen::VectorXd Shell::masses(double director_shift) const {
    Eigen::VectorXd mass = Eigen::VectorXd::Zero(count());
    for (const std::array<int, 3>& corner : triangles_) {
        const Eigen::Vector2d first = rest(corner[1]) - rest(corner[0]),
                              second = rest(corner[2]) - rest(corner[0]);
        const double third = (first[0] * second[1] - first[1] * second[0]) / 6.0; // of the area
        for (int vertex : corner) {
            for (int k = 0; k < 3; ++k) {
                if (number_[vertex][k] >= 0)
                    mass[number_[vertex][k]] += third;
            }
        }
    }
    for (const std::array<int, 5>& number : number_) {
        for (int k = 3; k < 5; ++k) {
            if (number[k] >= 0)
                mass[number[k]] += director_shift * scales_.flexural_rigidity;
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

Eigen::MatrixXd Shell::gathered(const double* numbers, int fields) const {
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(count(), fields);
    for (const std::array<int, 5>& number : number_) {
        for (int k = 0; k < 5; ++k, numbers += fields) {
            if (number[k] >= 0)
                columns.row(number[k]) += Eigen::Map<const Eigen::RowVectorXd>(numbers, fields);
        }
    }
    return columns;
}

void Shell::spread(const Eigen::MatrixXd& columns, double* moves) const {
    const Eigen::Index fields = columns.cols();
    for (const std::array<int, 5>& number : number_) {
        for (int k = 0; k < 3; ++k, moves += fields) {
            Eigen::Map<Eigen::RowVectorXd> row(moves, fields);
            if (number[k] >= 0)
                row = columns.row(number[k]);
            else
                row.setZero();
        }
    }
}

} // namespace film
