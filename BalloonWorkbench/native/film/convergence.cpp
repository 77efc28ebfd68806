// SPDX-License-Identifier: LGPL-2.1-or-later
#include "convergence.h"

#include <cmath>

namespace film {

Convergence::Convergence(const Shell& shell, double tolerance, const film_constants& constants)
    : tolerance_(tolerance), constants_(constants) {
    for (int vertex = 0; vertex < shell.vertices(); ++vertex) {
        if (shell.held(vertex, 2) && !shell.held(vertex, 0) && !shell.held(vertex, 1))
            seam_.push_back(vertex);
    }
}

bool Convergence::at_rest(const Vectors& before, const Vectors& after, const Energies& energy,
                          const Energies& next, double length, double decrement, bool held_back) {
    const bool still = !held_back && !seam_.empty()
                       && decrement <= constants_.still_decrement * tolerance_ * std::abs(next.total())
                       && std::abs(next.pressure - energy.pressure)
                              <= constants_.still_volume * tolerance_ * length * std::abs(next.pressure)
                       && movement(before, after) <= constants_.still_seam * std::sqrt(tolerance_) * length;
    steps_ = still ? steps_ + 1 : 0;
    return steps_ >= constants_.still_steps;
}

// Of the seam, root mean square, without what it moves and turns as a whole.
double Convergence::movement(const Vectors& before, const Vectors& after) const {
    const auto count = static_cast<Eigen::Index>(seam_.size());
    Eigen::Matrix2Xd place(2, count), move(2, count);
    for (Eigen::Index k = 0; k < count; ++k) {
        const int vertex = seam_[static_cast<size_t>(k)];
        place.col(k) = before.row(vertex).head<2>();
        move.col(k) = (after.row(vertex) - before.row(vertex)).head<2>();
    }
    place.colwise() -= place.rowwise().mean().eval();
    move.colwise() -= move.rowwise().mean().eval();
    const double turn = (place.row(0).dot(move.row(1)) - place.row(1).dot(move.row(0))) / place.squaredNorm();
    move.row(0) += turn * place.row(1);
    move.row(1) -= turn * place.row(0);
    return std::sqrt(move.squaredNorm() / static_cast<double>(count));
}

} // namespace film
