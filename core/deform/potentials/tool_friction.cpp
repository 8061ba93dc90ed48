// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/tool_friction.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/deform/potentials/point_stiffness.h"

namespace hepatica {
namespace {

constexpr double creep_edges_per_s = 1e-5;
constexpr double slowing = 0.05;

}  // namespace

void ToolFriction::begin_step(const BodyState& start, double dt_s,
                              std::span<const std::uint8_t> held) {
    grips_.clear();
    held_ = held;
    if (!contact_.tool() || contact_.tool()->friction == 0.0) return;
    creep_mm_ = creep_edges_per_s * body_.mean_edge_mm * dt_s;
    std::vector<PadContact> touching = contact_.contacts_before_led(start.positions_mm);
    // In a later part of a step the body may have moved into the tool's former place.
    const auto closed = [](const PadContact& contact) { return !std::isfinite(contact.energy_nj); };
    if (std::ranges::any_of(touching, closed)) touching = contact_.contacts(start.positions_mm);
    for (const PadContact& contact : touching) {
        Grip grip{contact_.nodes_of(contact), contact.weights, contact.normal,
                  contact_.tool()->friction * contact.force_un, Vec3::Zero()};
        // The touched point is dragged with the nearest point of the tool's axis.
        const ToolPart& part = contact_.tool()->parts[contact.part];
        const Vec3 led = part.led_by_mm + (2.0 * contact.along - 1.0) * part.led_half_axis_mm;
        const Vec3 dragged = dt_s * (led / contact_.tool()->led_over_s);
        grip.anchor_mm = point_of(grip, start.positions_mm) + dragged;
        grips_.push_back(grip);
    }
}

Vec3 ToolFriction::point_of(const Grip& grip, std::span<const Vec3> positions_mm) {
    Vec3 point = Vec3::Zero();
    for (int a = 0; a < 3; ++a) point += grip.weights[a] * positions_mm[grip.nodes[a]];
    return point;
}

Vec3 ToolFriction::slip_of(const Grip& grip, std::span<const Vec3> positions_mm) {
    const Vec3 moved = point_of(grip, positions_mm) - grip.anchor_mm;
    return moved - moved.dot(grip.normal) * grip.normal;
}

double ToolFriction::energy_of(const Grip& grip, std::span<const Vec3> positions_mm) const {
    const double y = slip_of(grip, positions_mm).norm(), e = creep_mm_;
    return grip.limit_un * (y < e ? y * y / e * (1.0 - y / (3.0 * e)) : y - e / 3.0);
}

Vec3 ToolFriction::force_of(const Grip& grip, std::span<const Vec3> positions_mm) const {
    const Vec3 slip = slip_of(grip, positions_mm);
    const double y = slip.norm(), e = creep_mm_;
    return (y < e ? -grip.limit_un / e * (2.0 - y / e) : -grip.limit_un / y) * slip;
}

Mat3 ToolFriction::stiffness_of(const Grip& grip, std::span<const Vec3> positions_mm) const {
    const Vec3 slip = slip_of(grip, positions_mm);
    const double y = slip.norm(), e = creep_mm_;
    const Mat3 plane = Mat3::Identity() - grip.normal * grip.normal.transpose();
    if (y == 0.0) return 2.0 * grip.limit_un / e * plane;
    const Vec3 s = slip / y;
    const double across = y < e ? (2.0 - y / e) / e : 1.0 / y;
    const double along = y < e ? 2.0 * (1.0 - y / e) / e : (grip.slows ? 1.0 / y : 0.0);
    return grip.limit_un * (across * (plane - s * s.transpose()) + along * s * s.transpose());
}

// What slips is about to stick where the other forces that act on it fall short of friction by
// `slowing` of that. Both are shared out to the nodes.
void ToolFriction::foresee(std::span<const Vec3> positions_mm, std::span<const Vec3> forces_un) {
    std::unordered_map<int, double> limit_un;
    for (const Grip& grip : grips_)
        for (int a = 0; a < 3; ++a) limit_un[grip.nodes[a]] += grip.weights[a] * grip.limit_un;
    for (Grip& grip : grips_) {
        const Vec3 slip = slip_of(grip, positions_mm);
        double pressing = 0.0;
        for (int a = 0; a < 3; ++a)
            if (const double limit = limit_un[grip.nodes[a]]; limit > 0.0)
                pressing += grip.weights[a] * forces_un[grip.nodes[a]].dot(slip) / limit;
        grip.slows = pressing < -slowing * slip.norm();
    }
}

std::vector<ToolFriction::PointForce> ToolFriction::point_forces(
    std::span<const Vec3> positions_mm) const {
    std::vector<PointForce> forces;
    for (const Grip& grip : grips_)
        forces.push_back({point_of(grip, positions_mm), force_of(grip, positions_mm)});
    return forces;
}

double ToolFriction::energy(std::span<const Vec3> positions_mm, std::span<const Vec3>) const {
    double sum = 0.0;
    for (const Grip& grip : grips_) sum += energy_of(grip, positions_mm);
    return sum;
}

void ToolFriction::add_energy_by_piece(std::span<const Vec3> positions_mm, std::span<const Vec3>,
                                       std::span<const int> piece_of_node,
                                       std::span<double> energy_nj) const {
    for (const Grip& grip : grips_)
        energy_nj[piece_of_node[grip.nodes[0]]] += energy_of(grip, positions_mm);
}

void ToolFriction::add_forces(std::span<const Vec3> positions_mm, std::span<Vec3> forces_un) const {
    for (const Grip& grip : grips_) {
        const Vec3 force = force_of(grip, positions_mm);
        for (int a = 0; a < 3; ++a) forces_un[grip.nodes[a]] += grip.weights[a] * force;
    }
}

void ToolFriction::add_stiffness(std::span<const Vec3> positions_mm, double factor,
                                 BlockMatrix& matrix) const {
    for (const Grip& grip : grips_)
        add_point_stiffness(grip.nodes, grip.weights, factor * stiffness_of(grip, positions_mm),
                            held_, matrix);
}

void ToolFriction::add_product(std::span<const Vec3> positions_mm, double factor,
                               std::span<const Vec3> d, const BlockMatrix&,
                               std::span<Vec3> product) const {
    for (const Grip& grip : grips_)
        add_point_product(grip.nodes, grip.weights, factor * stiffness_of(grip, positions_mm), d,
                          product);
}

}  // namespace hepatica
