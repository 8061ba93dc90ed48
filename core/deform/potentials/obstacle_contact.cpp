// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/obstacle_contact.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/deform/potentials/point_stiffness.h"

namespace hepatica {

ObstacleContact::ObstacleContact(const Body& body) : body_(body) {
    WithObstacles both =
        with_obstacles(*body.obstacles, body.rest_positions_mm, body.touching_surface);
    rest_mm_ = std::move(both.positions_mm);
    from_mm_ = to_mm_ = rest_mm_;
    pairs_.emplace(SurfaceFeatures(SurfacePatches(std::move(both.triangles)), rest_mm_, both.kinds),
                   rest_mm_, body.node_count(), body.obstacle_pad, body.mean_edge_mm);
}

std::span<const Vec3> ObstacleContact::all_from(std::span<const Vec3> positions_mm) const {
    std::ranges::copy(positions_mm, from_mm_.begin());
    return from_mm_;
}

// Returns the same span as all_from() where nothing moves, because the search is cheaper then.
std::span<const Vec3> ObstacleContact::all_to(std::span<const Vec3> from_mm,
                                              std::span<const Vec3> to_mm) const {
    if (from_mm.data() == to_mm.data()) return from_mm_;
    std::ranges::copy(to_mm, to_mm_.begin());
    return to_mm_;
}

const std::vector<SurfaceContact>& ObstacleContact::contacts(
    std::span<const Vec3> positions_mm) const {
    return pairs_->contacts(all_from(positions_mm));
}

void ObstacleContact::list_touches(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm,
                                   std::vector<PadPair>& list) const {
    const auto from = all_from(from_mm);
    pairs_->list_touches(from, all_to(from_mm, to_mm), list);
}

ObstacleContactPoint ObstacleContact::point_of(const SurfaceContact& contact) const {
    const PointPair& at = contact.at;
    const bool first = at.nodes[0] < body_.node_count();
    const int begin = first ? 0 : at.in_first, count = first ? at.in_first : 4 - at.in_first;
    ObstacleContactPoint point;
    for (int a = 0; a < 3; ++a) {
        point.nodes[a] = at.nodes[begin + std::min(a, count - 1)];
        if (a < count) point.weights[a] = std::abs(at.weights[begin + a]);
    }
    point.normal = first ? contact.normal : Vec3(-contact.normal);
    return point;
}

double ObstacleContact::energy(std::span<const Vec3> positions_mm, std::span<const Vec3>) const {
    double sum = 0.0;
    for (const SurfaceContact& contact : contacts(positions_mm)) sum += contact.energy_nj;
    return sum;
}

void ObstacleContact::add_energy_by_piece(std::span<const Vec3> positions_mm, std::span<const Vec3>,
                                          std::span<const int> piece_of_node,
                                          std::span<double> energy_nj) const {
    for (const SurfaceContact& contact : contacts(positions_mm))
        energy_nj[piece_of_node[point_of(contact).nodes[0]]] += contact.energy_nj;
}

void ObstacleContact::add_forces(std::span<const Vec3> positions_mm,
                                 std::span<Vec3> forces_un) const {
    for (const SurfaceContact& contact : contacts(positions_mm)) {
        const Vec3 force = contact.force_un * contact.normal;
        for (int a = 0; a < 4; ++a)
            if (const int node = contact.at.nodes[a]; node < body_.node_count())
                forces_un[node] += contact.at.weights[a] * force + contact.turning_un[a];
    }
}

void ObstacleContact::add_stiffness(std::span<const Vec3> positions_mm, double factor,
                                    BlockMatrix& matrix) const {
    for (const SurfaceContact& contact : contacts(positions_mm)) {
        const ObstacleContactPoint point = point_of(contact);
        add_point_stiffness(point.nodes, point.weights, factor * along_normal(contact), held_,
                            matrix);
    }
}

void ObstacleContact::add_product(std::span<const Vec3> positions_mm, double factor,
                                  std::span<const Vec3> d, const BlockMatrix&,
                                  std::span<Vec3> product) const {
    for (const SurfaceContact& contact : contacts(positions_mm)) {
        const ObstacleContactPoint point = point_of(contact);
        add_point_product(point.nodes, point.weights, factor * along_normal(contact), d, product);
    }
}

void ObstacleContact::mark_held(std::span<const Vec3> positions_mm, std::span<char> held) const {
    for (const SurfaceContact& contact : contacts(positions_mm))
        for (const int node : point_of(contact).nodes) held[node] = 1;
}

double ObstacleContact::free_share(std::span<const Vec3> from_mm,
                                   std::span<const Vec3> to_mm) const {
    const auto from = all_from(from_mm);
    return pairs_->free_share(from, all_to(from_mm, to_mm));
}

double ObstacleContact::share_until_touch(std::span<const Vec3> from_mm,
                                          std::span<const Vec3> to_mm) const {
    const auto from = all_from(from_mm);
    return pairs_->share_until_touch(from, all_to(from_mm, to_mm));
}

std::vector<Grip> ObstacleFriction::grips_of(std::span<const Vec3> start_mm, double) const {
    std::vector<Grip> grips;
    if (contact_.friction() == 0.0) return grips;
    const std::vector<SurfaceContact>& contacts = contact_.contacts(start_mm);
    grips.resize(contacts.size());
    parallel_blocks(contacts.size(), grips_per_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const ObstacleContactPoint point = contact_.point_of(contacts[k]);
            Grip grip{point.nodes, point.weights, point.normal,
                      contact_.friction() * contacts[k].force_un, Vec3::Zero()};
            grip.anchor_mm = grip.point(start_mm);
            grips[k] = grip;
        }
    });
    return grips;
}

ObstacleLoad load_of(const ObstacleContact& contact, const ObstacleFriction& friction,
                     std::span<const Vec3> positions_mm) {
    ObstacleLoad load;
    load.touch = load_of(contact.contacts(positions_mm));
    std::vector<Vec3> on_body(positions_mm.size(), Vec3::Zero());
    contact.add_forces(positions_mm, on_body);
    for (const auto& point : friction.point_forces(positions_mm)) load.force_un -= point.force_un;
    for (const Vec3& force : on_body) load.force_un -= force;
    return load;
}

}  // namespace hepatica
