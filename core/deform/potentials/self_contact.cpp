// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/self_contact.h"

namespace hepatica {

SelfContact::SelfContact(const Body& body)
    : pairs_(SurfaceFeatures(SurfacePatches(body.touching_surface), body.rest_positions_mm),
             body.rest_positions_mm, body.node_count(), *body.self_pad, body.mean_edge_mm) {}

double SelfContact::energy(std::span<const Vec3> positions_mm, std::span<const Vec3>) const {
    double sum = 0.0;
    for (const SurfaceContact& contact : contacts(positions_mm)) sum += contact.energy_nj;
    return sum;
}

void SelfContact::add_energy_by_piece(std::span<const Vec3> positions_mm, std::span<const Vec3>,
                                      std::span<const int> piece_of_node,
                                      std::span<double> energy_nj) const {
    for (const SurfaceContact& contact : contacts(positions_mm))
        energy_nj[piece_of_node[contact.of.nodes[0]]] += contact.energy_nj;
}

void SelfContact::add_forces(std::span<const Vec3> positions_mm, std::span<Vec3> forces_un) const {
    for (const SurfaceContact& contact : contacts(positions_mm)) {
        contact.at.add_force(contact.force_un * contact.normal, forces_un);
        for (int a = 0; a < 4; ++a) forces_un[contact.of.nodes[a]] += contact.turning_un[a];
    }
}

void SelfContact::add_stiffness(std::span<const Vec3> positions_mm, double factor,
                                BlockMatrix& matrix) const {
    note_meeting(positions_mm);
    for (const SurfaceContact& contact : contacts(positions_mm))
        add_within(contact.at, factor * along_normal(contact), held_, matrix);
}

void SelfContact::add_product(std::span<const Vec3> positions_mm, double factor,
                              std::span<const Vec3> d, const BlockMatrix&,
                              std::span<Vec3> product) const {
    for (const SurfaceContact& contact : contacts(positions_mm))
        add_pair_product(contact.at, factor * along_normal(contact), true, {}, d, product);
}

void SelfContact::add_coupling(std::span<const Vec3> positions_mm, double factor,
                               std::span<const Vec3> d, std::span<Vec3> product) const {
    for (const SurfaceContact& contact : contacts(positions_mm))
        add_pair_product(contact.at, factor * along_normal(contact), false, held_, d, product);
}

void SelfContact::append_coupling(std::span<const Vec3> positions_mm, double factor,
                                  CouplingBlocks& blocks) const {
    for (const SurfaceContact& contact : contacts(positions_mm))
        append_pair_coupling(contact.at, factor * along_normal(contact), held_, blocks);
}

void SelfContact::join_pieces(std::span<const int> piece_of_node, DisjointSets& pieces) const {
    const auto join = [&](int node, int other) {
        pieces.unite(piece_of_node[node], piece_of_node[other]);
    };
    for (const auto& [node, other] : met_) join(node, other);
    for (const SurfaceContact& contact : pairs_.last_contacts())
        join(contact.of.nodes[0], contact.of.nodes[3]);
}

void SelfContact::begin_step(const BodyState& start, double, std::span<const std::uint8_t> held) {
    held_ = held;
    met_.clear();
    note_meeting(start.positions_mm);
}

void SelfContact::note_meeting(std::span<const Vec3> positions_mm) const {
    for (const SurfaceContact& contact : contacts(positions_mm))
        met_.push_back({contact.of.nodes[0], contact.of.nodes[3]});
}

void SelfContact::end_step() {
    held_ = {};
    met_.clear();
}

}  // namespace hepatica
