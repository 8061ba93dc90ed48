// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/tool_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/deform/potentials/pad_barrier.h"
#include "core/deform/potentials/point_stiffness.h"

namespace hepatica {
namespace {

constexpr double least_share = 0.1;   // of a gap, that a motion leaves
constexpr double led_until = 0.5;     // of the pad
constexpr double dip_of_pad = 0.125;  // how far a triangle may bulge into the pad between points
constexpr double most_stretch = 1.5;  // of the surface, for which that holds
constexpr int most_cuts = 32;         // of a triangle's edge

}  // namespace

ToolContact::ToolContact(const Body& body) : surface_(body.surface) {
    for (const auto& triangle : surface_.triangles()) {
        const Triangle x = corners_of(triangle, body.rest_positions_mm);
        area_mm2_.push_back(0.5 * (x[1] - x[0]).cross(x[2] - x[0]).norm());
        longest_edge_mm_.push_back(
            std::max({(x[1] - x[0]).norm(), (x[2] - x[1]).norm(), (x[0] - x[2]).norm()}));
    }
}

// The corners of n^2 equal triangles into which it is cut; each of those gives a third of its area
// to each of its corners. A point of a triangle of edges s is at most s / sqrt(3) from a corner,
// and the ball bulges there by s^2 / (6 R).
void ToolContact::add_points_of(int triangle, const Capsule& shape, int part,
                                std::span<const Vec3> positions_mm,
                                std::vector<PadContact>& found) const {
    const double pad = tool_->pad_mm, edge = longest_edge_mm_[triangle];
    const double apart = std::sqrt(6.0 * dip_of_pad * pad * shape.radius_mm) / most_stretch;
    const int n = std::clamp(static_cast<int>(std::ceil(edge / apart)), 1, most_cuts);
    const double dip =
        std::min(dip_of_pad * pad, std::pow(most_stretch * edge / n, 2) / (6.0 * shape.radius_mm));
    const Triangle corners = corners_of(surface_.triangles()[triangle], positions_mm);
    const Segment axis = shape.axis();
    for (int i = 0; i <= n; ++i)
        for (int j = 0; i + j <= n; ++j) {
            const double v = static_cast<double>(i) / n, w = static_cast<double>(j) / n;
            const std::array<double, 3> weights{static_cast<double>(n - i - j) / n, v, w};
            const Vec3 point = point_at(corners, weights);
            const PointSegment on = closest(point, axis);
            const double distance = std::sqrt(on.squared_mm2);
            const double gap = distance - shape.radius_mm - dip;
            if (!(gap < pad)) continue;
            const int on_borders = (i == 0) + (j == 0) + (i + j == n);
            const double share = on_borders == 0 ? 6.0 : (on_borders == 1 ? 3.0 : 1.0);
            const double strength =
                share / (3.0 * n * n) * area_mm2_[triangle] * tool_->pressure_pa;
            const PadBarrier barrier = pad_barrier(gap, pad, strength);
            const Vec3 normal = (point - point_at(axis, on.along)) / distance;
            found.push_back({part, on.along, triangle, weights, normal, point, barrier.force_un,
                             barrier.stiffness_un_per_mm, barrier.energy_nj});
        }
}

std::vector<PadContact> ToolContact::contacts_at(std::span<const Capsule> shapes,
                                                 std::span<const Vec3> positions_mm) const {
    std::vector<Box> boxes(shapes.size());
    for (std::size_t p = 0; p < shapes.size(); ++p) {
        for (const Vec3& end : shapes[p].axis()) boxes[p].add(end);
        boxes[p].grow(shapes[p].radius_mm + (1.0 + dip_of_pad) * tool_->pad_mm);
    }
    const std::vector<std::vector<int>> near = surface_.triangles_in(boxes, positions_mm);
    std::vector<PadContact> found;
    for (std::size_t p = 0; p < shapes.size(); ++p)
        for (const int t : near[p])
            add_points_of(t, shapes[p], static_cast<int>(p), positions_mm, found);
    return found;
}

std::vector<PadContact> ToolContact::contacts(std::span<const Vec3> positions_mm) const {
    return tool_ ? contacts_at(tool_->shapes(), positions_mm) : std::vector<PadContact>{};
}

std::vector<PadContact> ToolContact::contacts_before_led(std::span<const Vec3> positions_mm) const {
    return tool_ ? contacts_at(tool_->shapes_before_led(), positions_mm)
                 : std::vector<PadContact>{};
}

double ToolContact::least_gap_mm(std::span<const Vec3> positions_mm) const {
    double least = std::numeric_limits<double>::max();
    if (!tool_) return least;
    for (const ToolPart& part : tool_->parts)
        for (const NearTriangle& near :
             near_capsule(part.shape, surface_, positions_mm, (1.0 + dip_of_pad) * tool_->pad_mm))
            least = std::min(least, near.gap_mm);
    return least;
}

bool ToolContact::free(std::span<const Vec3> positions_mm) const {
    return least_gap_mm(positions_mm) > 0.0 && std::isfinite(energy(positions_mm, positions_mm));
}

// Of the pad alone. Jaws are pressed apart by the force that works where they open.
ToolResistance ToolContact::resistance_at(std::span<const Capsule> shapes,
                                          std::span<const Vec3> positions_mm) const {
    ToolResistance sum;
    Vec3 centre = Vec3::Zero();
    for (const Capsule& shape : shapes) centre += shape.centre_mm;
    centre /= static_cast<double>(shapes.size());
    for (const PadContact& contact : contacts_at(shapes, positions_mm)) {
        const Vec3 force = contact.force_un * contact.normal;
        sum.force_un -= force;
        sum.torque_un_mm -= (contact.at_mm - centre).cross(force);
        sum.grip_un -= force.dot(tool_->parts[contact.part].opens);
        sum.closed = sum.closed || !std::isfinite(contact.energy_nj);
    }
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
    for (std::size_t p = 0; p < surface_.size(); ++p) {
        if (!surface_.box(p, positions_mm).meets(way)) continue;
        const auto vertices = surface_.vertices_of(p);
        near.insert(near.end(), vertices.begin(), vertices.end());
    }
    return near;
}

bool ToolContact::lead(std::span<const Vec3> positions_mm, double share, double dt_s) {
    return hepatica::lead(
        *tool_, surface_, positions_mm, led_until * tool_->pad_mm, share, dt_s,
        [&](std::span<const Capsule> shapes) { return resistance_at(shapes, positions_mm); });
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
        share = std::min(
            share, hepatica::free_share(part.shape, surface_, from_mm, to_mm, [&](double gap_mm) {
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
            share, hepatica::free_share(part.shape, surface_, from_mm, to_mm, [&](double gap_mm) {
                return gap_mm > tool_->pad_mm ? led_until * tool_->pad_mm : -1.0;
            }));
    return share;
}

}  // namespace hepatica
