// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/softening_ties.h"

#include <algorithm>
#include <utility>

namespace hepatica {
namespace {

Vec3 opening_of(const SofteningTie& tie, std::span<const Vec3> x) {
    return x[tie.vertices[1]] - x[tie.vertices[0]];
}

void turn_one(SofteningTie& tie, std::span<const Vec3> x) {
    const auto& [a, b, c] = tie.triangle;
    const Vec3 doubled = (x[b] - x[a]).cross(x[c] - x[a]);
    const double length = doubled.norm();
    if (length > 0.0) tie.normal = doubled / length;
}

// With the turned normal, an opening that was sideways may become compression, in which a damaged
// tie is stiffer. To keep the tie from gaining energy, its damage (the largest opening so far) is
// increased until it stores no more than `allowed_nj`.
void pay_for_turn(const SofteningLaw& law, SofteningTie& tie, const Vec3& opening,
                  double allowed_nj) {
    if (energy_of(law, tie, opening) <= allowed_nj) return;
    const double open = effective_opening_mm(tie, opening);
    tie.most_mm = std::clamp(open, tie.most_mm, law.opening_mm);
    const double excess = energy_of(law, tie, opening) - allowed_nj;
    if (!(excess > 0.0) || tie.most_mm >= law.opening_mm) return;
    const double half_square = 0.5 * tie.area_mm2 * open * open;
    // The largest stiffness for which A k(m) o^2 / 2 at the opening o <= m is within the allowance.
    const double stiffness =
        law.unloading_pa_mm(tie.most_mm) - excess / std::max(half_square, 1e-300);
    const double span = law.opening_mm - law.peak_mm();
    tie.most_mm = stiffness > 0.0
                      ? law.strength_pa * law.opening_mm / (stiffness * span + law.strength_pa)
                      : law.opening_mm;
}

}  // namespace

void SofteningTies::set(const SofteningLaw& law, std::vector<SofteningTie> ties,
                        std::span<const Vec3> positions_mm) {
    law_ = law;
    ties_ = std::move(ties);
    turn(positions_mm);
}

void SofteningTies::turn(std::span<const Vec3> positions_mm) {
    for (SofteningTie& tie : ties_) turn_one(tie, positions_mm);
}

void SofteningTies::list_touches(TouchList& list) const {
    list.softening = law_;
    for (const SofteningTie& tie : ties_)
        if (tie.most_mm < law_.opening_mm)
            list.ties.push_back({{tie.vertices[0], tie.vertices[1]}, corner_of(tie)});
}

double SofteningTies::settle(std::span<const Vec3> positions_mm) {
    double loss = 0.0;
    for (SofteningTie& tie : ties_) {
        if (tie.most_mm >= law_.opening_mm) continue;  // it has come apart
        const Vec3 opening = opening_of(tie, positions_mm);
        const double before = energy_of(law_, tie, opening);
        tie.most_mm = std::clamp(effective_opening_mm(tie, opening), tie.most_mm, law_.opening_mm);
        const double softened = energy_of(law_, tie, opening);
        turn_one(tie, positions_mm);
        pay_for_turn(law_, tie, opening, softened);
        loss += before - energy_of(law_, tie, opening);
    }
    return loss;
}

double SofteningTies::energy(std::span<const Vec3> positions_mm, std::span<const Vec3>) const {
    double sum = 0.0;
    for (const SofteningTie& tie : ties_)
        sum += energy_of(law_, tie, opening_of(tie, positions_mm));
    return sum;
}

void SofteningTies::add_energy_by_piece(std::span<const Vec3> positions_mm, std::span<const Vec3>,
                                        std::span<const int> piece_of_node,
                                        std::span<double> energy_nj) const {
    for (const SofteningTie& tie : ties_)
        energy_nj[piece_of_node[tie.vertices[0]]] +=
            energy_of(law_, tie, opening_of(tie, positions_mm));
}

void SofteningTies::add_forces(std::span<const Vec3> positions_mm,
                               std::span<Vec3> forces_un) const {
    for (const SofteningTie& tie : ties_) {
        const Vec3 force = force_of(law_, tie, opening_of(tie, positions_mm));
        forces_un[tie.vertices[0]] += force;
        forces_un[tie.vertices[1]] -= force;
    }
}

// Rows of held nodes are skipped, because they are not assembled anew in every step.
void SofteningTies::add_stiffness(std::span<const Vec3> positions_mm, double factor,
                                  BlockMatrix& matrix) const {
    for (const SofteningTie& tie : ties_) {
        const auto& [a, b] = tie.vertices;
        const Mat3 block = factor * stiffness_of(law_, tie, opening_of(tie, positions_mm));
        if (!held(a)) matrix.block[matrix.diagonal[a]] += block;
        if (!held(b)) matrix.block[matrix.diagonal[b]] += block;
        if (held(a) || held(b)) continue;
        matrix.block[matrix.find(a, b)] -= block;
        matrix.block[matrix.find(b, a)] -= block;
    }
}

void SofteningTies::add_product(std::span<const Vec3> positions_mm, double factor,
                                std::span<const Vec3> d, const BlockMatrix&,
                                std::span<Vec3> product) const {
    for (const SofteningTie& tie : ties_) {
        const auto& [a, b] = tie.vertices;
        const Vec3 force =
            factor * (stiffness_of(law_, tie, opening_of(tie, positions_mm)) * (d[a] - d[b]));
        product[a] += force;
        product[b] -= force;
    }
}

void SofteningTies::join_pieces(std::span<const int> piece_of_node, DisjointSets& pieces) const {
    for (const SofteningTie& tie : ties_)
        if (tie.most_mm < law_.opening_mm)
            pieces.unite(piece_of_node[tie.vertices[0]], piece_of_node[tie.vertices[1]]);
}

}  // namespace hepatica
