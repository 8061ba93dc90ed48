// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/tool_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/deform/potentials/point_stiffness.h"
#include "core/deform/potentials/thin_pads.h"
#include "core/deform/potentials/tool_load_sum.h"

namespace hepatica {
namespace {

constexpr double least_share = 0.1;  // of a gap, that a motion must leave
constexpr double led_until = 0.5;    // of the pad, that a led tool leaves

}  // namespace

ToolContact::ToolContact(const Body& body)
    : pad_(SurfacePatches(body.surface), body.rest_positions_mm) {
    if (!body.obstacles) return;
    for (const Obstacle& obstacle : body.obstacles->all) obstacles_.emplace_back(obstacle);
}

std::vector<PadContact> ToolContact::contacts(std::span<const Vec3> positions_mm) const {
    return tool_ ? pad_.contacts(*tool_, tool_->shapes(), positions_mm) : std::vector<PadContact>{};
}

std::vector<PadContact> ToolContact::contacts_before_led(std::span<const Vec3> positions_mm) const {
    return tool_ ? pad_.contacts(*tool_, tool_->shapes_before_led(), positions_mm)
                 : std::vector<PadContact>{};
}

void ToolContact::list_touches(std::span<const Vec3> positions_mm,
                               std::span<const Vec3> other_positions_mm, TouchList& list) const {
    if (!tool_) return;
    const std::vector<Capsule> shapes = tool_->shapes();
    for (const Capsule& shape : shapes) list.tool.push_back(pad_capsule(shape));
    list.points = pad_.points_near(*tool_, shapes, positions_mm, other_positions_mm);
}

double ToolContact::least_gap_mm(std::span<const Vec3> positions_mm) const {
    return tool_ ? pad_.least_gap_mm(*tool_, positions_mm) : std::numeric_limits<double>::max();
}

bool ToolContact::free(std::span<const Vec3> positions_mm) const {
    return least_gap_mm(positions_mm) > 0.0 && std::isfinite(energy(positions_mm, positions_mm));
}

std::vector<ThinPad> ToolContact::before_tear(std::span<const Vec3> positions_mm) const {
    return tool_ ? pads_before_split(*tool_, pad_.surface(), positions_mm) : std::vector<ThinPad>{};
}

void ToolContact::follow_split(std::span<const ThinPad> before, std::span<const int> node_before,
                               std::span<const Vec3> positions_mm) {
    if (tool_)
        tool_->thin_pads =
            thin_pads_after_split(before, *tool_, pad_.surface(), node_before, positions_mm);
}

void ToolContact::grow_thin_pads(std::span<const Vec3> positions_mm) {
    if (tool_) hepatica::grow_thin_pads(*tool_, pad_.surface(), positions_mm);
}

// Counts the body's pad alone: a rigid obstacle needs no limit. The force on the jaws is the
// generalised force of their opening.
ToolResistance ToolContact::resistance_at(std::span<const Capsule> shapes,
                                          std::span<const Vec3> positions_mm) const {
    ToolResistance sum;
    std::vector<double> on_part_un(tool_->parts.size(), 0.0);
    Vec3 centre = Vec3::Zero();
    for (const Capsule& shape : shapes) centre += shape.centre_mm;
    centre /= static_cast<double>(shapes.size());
    for (const PadContact& contact : pad_.contacts(*tool_, shapes, positions_mm)) {
        const Vec3 force = contact.force_un * contact.normal;
        sum.force_un -= force;
        sum.torque_un_mm -= (contact.at_mm - centre).cross(force);
        const double outwards_un = -force.dot(tool_->parts[contact.part].opens);
        sum.grip_un += outwards_un;
        on_part_un[contact.part] += outwards_un;
        sum.closed = sum.closed || !std::isfinite(contact.energy_nj);
    }
    double least_un = std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < tool_->parts.size(); ++p)
        if (!tool_->parts[p].opens.isZero(0.0)) least_un = std::min(least_un, on_part_un[p]);
    if (std::isfinite(least_un)) sum.held_un = std::max(0.0, least_un);
    return sum;
}

std::vector<int> ToolContact::vertices_near_way(std::span<const Vec3> positions_mm) const {
    Box way;
    const Vec3 to_go = tool_->target_mm - tool_->centre_mm();
    const bool turns = !tool_->turn_rad.isZero(0.0);
    double widest = 0.0, opens = std::abs(tool_->opening_target_mm - tool_->opening_mm);
    for (const ToolPart& part : tool_->parts) {
        widest = std::max(widest, part.shape.radius_mm);
        for (const Vec3& end : part.shape.axis()) {
            way.add(end);
            way.add(end + to_go);
        }
    }
    way.grow(turns ? tool_->reach_mm() : widest);
    way.grow(2.0 * tool_->pad_mm + opens);
    std::vector<int> near;
    for (std::size_t p = 0; p < pad_.surface().size(); ++p) {
        if (!pad_.surface().box(p, positions_mm).meets(way)) continue;
        const auto vertices = pad_.surface().vertices_of(p);
        near.insert(near.end(), vertices.begin(), vertices.end());
    }
    return near;
}

std::vector<const ToolObstacle*> ToolContact::obstacles_that_stop() const {
    std::vector<const ToolObstacle*> those;
    for (const ToolObstacle& obstacle : obstacles_)
        if (obstacle.stops(*tool_)) those.push_back(&obstacle);
    return those;
}

bool ToolContact::lead(std::span<const Vec3> positions_mm, double share, double dt_s) {
    StandingSurfaces surfaces{{pad_.surface(), positions_mm}};
    for (const ToolObstacle* obstacle : obstacles_that_stop())
        surfaces.push_back(obstacle->surface());
    return hepatica::lead(
        *tool_, surfaces, led_until * tool_->pad_mm, share, dt_s,
        [&](std::span<const Capsule> shapes) { return resistance_at(shapes, positions_mm); });
}

bool ToolContact::in_obstacle() const {
    return std::ranges::any_of(
        obstacles_, [&](const ToolObstacle& obstacle) { return obstacle.entered_by(*tool_); });
}

ToolContact::ObstaclePress ToolContact::pressed_by_obstacles() const {
    ObstaclePress press;
    ToolLoadSum sum(*tool_);
    const std::vector<Capsule> shapes = tool_->shapes();
    for (const ToolObstacle* obstacle : obstacles_that_stop()) {
        press.least_gap_mm = std::min(press.least_gap_mm, obstacle->least_gap_mm(*tool_));
        for (const PadContact& contact : obstacle->contacts(*tool_, shapes)) {
            press.contacts.push_back(contact);
            sum.press(contact);
        }
    }
    const ToolLoad load = sum.load();
    const double hardest = std::max(load.force_un.norm(), load.grip_un);
    if (hardest > tool_->force_limit_un) press.share = tool_->force_limit_un / hardest;
    return press;
}

double ToolContact::energy(std::span<const Vec3> positions_mm, std::span<const Vec3>) const {
    double sum = 0.0;
    for (const PadContact& contact : contacts(positions_mm)) sum += contact.energy_nj;
    return sum;
}

void ToolContact::add_energy_by_piece(std::span<const Vec3> positions_mm, std::span<const Vec3>,
                                      std::span<const int> piece_of_node,
                                      std::span<double> energy_nj) const {
    for (const PadContact& contact : contacts(positions_mm))
        energy_nj[piece_of_node[nodes_of(contact)[0]]] += contact.energy_nj;
}

void ToolContact::add_forces(std::span<const Vec3> positions_mm, std::span<Vec3> forces_un) const {
    for (const PadContact& contact : contacts(positions_mm))
        for (int a = 0; a < 3; ++a)
            forces_un[nodes_of(contact)[a]] +=
                contact.weights[a] * contact.force_un * contact.normal;
}

void ToolContact::add_stiffness(std::span<const Vec3> positions_mm, double factor,
                                BlockMatrix& matrix) const {
    for (const PadContact& contact : contacts(positions_mm)) {
        const Mat3 along =
            contact.stiffness_un_per_mm * contact.normal * contact.normal.transpose();
        add_point_stiffness(nodes_of(contact), contact.weights, factor * along, held_, matrix);
    }
}

void ToolContact::add_product(std::span<const Vec3> positions_mm, double factor,
                              std::span<const Vec3> d, const BlockMatrix&,
                              std::span<Vec3> product) const {
    for (const PadContact& contact : contacts(positions_mm)) {
        const Mat3 along =
            contact.stiffness_un_per_mm * contact.normal * contact.normal.transpose();
        add_point_product(nodes_of(contact), contact.weights, factor * along, d, product);
    }
}

void ToolContact::mark_held(std::span<const Vec3> positions_mm, std::span<char> held) const {
    for (const PadContact& contact : contacts(positions_mm))
        for (const int v : nodes_of(contact)) held[v] = 1;
}

double ToolContact::free_share(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm) const {
    double share = 1.0;
    if (!tool_) return share;
    for (const ToolPart& part : tool_->parts)
        share = std::min(share, hepatica::free_share(
                                    part.shape, pad_.surface(), from_mm, to_mm, [&](double gap_mm) {
                                        return least_share * std::min(gap_mm, tool_->pad_mm);
                                    }));
    return share;
}

double ToolContact::share_until_touch(std::span<const Vec3> from_mm,
                                      std::span<const Vec3> to_mm) const {
    double share = 1.0;
    if (!tool_) return share;
    for (const ToolPart& part : tool_->parts)
        share = std::min(
            share,
            hepatica::free_share(part.shape, pad_.surface(), from_mm, to_mm, [&](double gap_mm) {
                return gap_mm > tool_->pad_mm ? led_until * tool_->pad_mm : -1.0;
            }));
    return share;
}

}  // namespace hepatica
