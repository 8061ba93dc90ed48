// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/grab_springs.h"

#include <cmath>

namespace hepatica {
namespace {

struct Pull {
    Vec3 stretch_mm;  // from the held point to the target
    double length_mm;
    double limit_mm;  // stretch at which the force stops growing
};

Pull pull_of(const Grab& grab, std::span<const Vec3> positions) {
    Vec3 stretch = Vec3::Zero();  // from differences: exact for a body far from the origin
    for (int a = 0; a < 4; ++a)
        if (grab.vertices[a] >= 0)
            stretch += grab.weights[a] * (grab.target_mm - positions[grab.vertices[a]]);
    return {stretch, stretch.norm(), grab.force_limit_un / grab.stiffness_un_per_mm};
}

double energy_of(const Grab& grab, std::span<const Vec3> positions) {
    const Pull pull = pull_of(grab, positions);
    return pull.length_mm <= pull.limit_mm
               ? 0.5 * grab.stiffness_un_per_mm * pull.length_mm * pull.length_mm
               : grab.force_limit_un * (pull.length_mm - 0.5 * pull.limit_mm);
}

Mat3 stiffness_of(const Grab& grab, const Pull& pull) {
    if (pull.length_mm <= pull.limit_mm) return grab.stiffness_un_per_mm * Mat3::Identity();
    const Vec3 n = pull.stretch_mm / pull.length_mm;
    return (grab.force_limit_un / pull.length_mm) * (Mat3::Identity() - n * n.transpose());
}

}  // namespace

double GrabSprings::energy(std::span<const Vec3> positions_mm, std::span<const Vec3>) const {
    double sum = 0.0;
    for (const Grab& grab : grabs_) sum += energy_of(grab, positions_mm);
    return sum;
}

void GrabSprings::add_energy_by_piece(std::span<const Vec3> positions_mm, std::span<const Vec3>,
                                      std::span<const int> piece_of_node,
                                      std::span<double> energy_nj) const {
    for (const Grab& grab : grabs_)
        energy_nj[piece_of_node[grab.vertices[0]]] += energy_of(grab, positions_mm);
}

void GrabSprings::add_forces(std::span<const Vec3> positions_mm, std::span<Vec3> forces_un) const {
    for (const Grab& grab : grabs_) {
        const Pull pull = pull_of(grab, positions_mm);
        const Vec3 force = pull.length_mm <= pull.limit_mm
                               ? Vec3(grab.stiffness_un_per_mm * pull.stretch_mm)
                               : Vec3(grab.force_limit_un / pull.length_mm * pull.stretch_mm);
        for (int a = 0; a < 4; ++a)
            if (grab.vertices[a] >= 0) forces_un[grab.vertices[a]] += grab.weights[a] * force;
    }
}

template <class Visit>
void GrabSprings::for_each_block(const Grab& grab, std::span<const Vec3> positions_mm,
                                 const BlockMatrix& pattern, const Visit& visit) const {
    const Mat3 stiffness = stiffness_of(grab, pull_of(grab, positions_mm));
    for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b) {
            const int i = grab.vertices[a], j = grab.vertices[b];
            if (i < 0 || j < 0) continue;
            const double weight = grab.weights[a] * grab.weights[b];
            const bool stored = pattern.find(i, j) >= 0;
            visit(i, stored ? j : i, (stored ? weight : std::abs(weight)) * stiffness);
        }
}

// Rows of held nodes are skipped, because they are not assembled anew in every step.
void GrabSprings::add_stiffness(std::span<const Vec3> positions_mm, double factor,
                                BlockMatrix& matrix) const {
    for (const Grab& grab : grabs_)
        for_each_block(grab, positions_mm, matrix, [&](int i, int j, const Mat3& block) {
            if (!held(i) && !held(j)) matrix.block[matrix.find(i, j)] += factor * block;
        });
}

void GrabSprings::add_product(std::span<const Vec3> positions_mm, double factor,
                              std::span<const Vec3> d, const BlockMatrix& pattern,
                              std::span<Vec3> product) const {
    for (const Grab& grab : grabs_)
        for_each_block(grab, positions_mm, pattern, [&](int i, int j, const Mat3& block) {
            product[i] += factor * (block * d[j]);
        });
}

void GrabSprings::mark_held(std::span<const Vec3>, std::span<char> held) const {
    for (const Grab& grab : grabs_)
        for (const int v : grab.vertices)
            if (v >= 0) held[v] = 1;
}

void GrabSprings::join_pieces(std::span<const int> piece_of_node, DisjointSets& pieces) const {
    for (const Grab& grab : grabs_)
        for (const int v : grab.vertices)
            if (v >= 0) pieces.unite(piece_of_node[grab.vertices[0]], piece_of_node[v]);
}

}  // namespace hepatica
