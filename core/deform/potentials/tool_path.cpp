// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/tool_path.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hepatica {
namespace {

constexpr int halvings_to_limit = 12;
constexpr double sagitta_of_gap = 1.0 / 40.0;
constexpr double least_turn_rad = 1e-9;
constexpr double most_pads_with_held = 0.3;  // a step

struct Way {
    Tool& tool;
    const StandingSurfaces& surfaces;
    double keep_mm;
    const ResistanceAt& resistance;

    void go(const Vec3& motion_mm);
    void go_on(const Vec3& motion_mm, double limit_un);
    void turn(const Vec3& by_rad);
    void open(double by_mm);

    // The largest share of the motion, found by bisection, at which the pad stays open and the body
    // does not push back `too_strong`ly; 1 where that holds at its `end`.
    template <class Pose, class TooStrong>
    double share_within(const Pose& pose, const ToolResistance& end,
                        const TooStrong& too_strong) const {
        const auto stops_at = [&](const ToolResistance& r) { return r.closed || too_strong(r); };
        const auto stops = [&](double share) { return stops_at(resistance(pose(share))); };
        if (!stops_at(end)) return 1.0;
        double low = 0.0, high = 1.0;
        for (int i = 0; i < halvings_to_limit; ++i) {
            const double middle = 0.5 * (low + high);
            (stops(middle) ? high : low) = middle;
        }
        return low;
    }
};

// What jaws hold goes with them, so that across them the force on a standing body says nothing of
// the force that is left when it has moved. They are led there until that exceeds the limit, and no
// faster than what they hold follows in a step, because it would be kicked ahead of them otherwise.
void Way::go(const Vec3& motion_mm) {
    for (ToolPart& part : tool.parts) part.led_by_mm.setZero();
    const ToolResistance now = resistance(tool.shapes());
    if (now.held_un == 0.0) return go_on(motion_mm, tool.force_limit_un);
    const Vec3 across = tool.parts.front().opens.normalized();
    const Vec3 with_held = motion_mm.dot(across) * across;
    go_on(motion_mm - with_held, tool.force_limit_un);
    if (with_held.isZero(0.0) ||
        (with_held.dot(now.force_un) < 0.0 && now.force_un.norm() > tool.force_limit_un))
        return;
    const double most_mm = most_pads_with_held * tool.pad_mm;
    go_on(std::min(1.0, most_mm / with_held.norm()) * with_held,
          std::numeric_limits<double>::max());
}

void Way::go_on(const Vec3& motion_mm, double limit_un) {
    const std::vector<Capsule> begin = tool.shapes();
    Vec3 gone = slide(begin, surfaces, motion_mm, keep_mm);
    const auto there = [&](double share) {
        std::vector<Capsule> moved = begin;
        for (Capsule& shape : moved) shape.centre_mm += share * gone;
        return moved;
    };
    const ToolResistance end = resistance(there(1.0));
    const bool against = gone.dot(end.force_un) < 0.0;
    const double share = share_within(there, end, [&](const ToolResistance& r) {
        return against && r.force_un.norm() > limit_un;
    });
    if (share < 1.0) gone *= share;
    for (ToolPart& part : tool.parts) {
        part.shape.centre_mm += gone;
        part.led_by_mm += gone;
    }
}

// Turns about the centre in small increments; the first one that is stopped ends the turn.
void Way::turn(const Vec3& by_rad) {
    const double angle = by_rad.norm(), reach = tool.reach_mm();
    if (angle < least_turn_rad) {
        tool.turn_rad -= by_rad;
        return;
    }
    const Vec3 axis = by_rad / angle, centre = tool.centre_mm();
    const double most = std::sqrt(8.0 * sagitta_of_gap * keep_mm / reach);
    const int count = std::max(1, static_cast<int>(std::ceil(angle / most)));
    const double limit_un_mm = tool.force_limit_un * reach;
    for (int i = 0; i < count; ++i) {
        const std::vector<Capsule> begin = tool.shapes();
        double share = 1.0;
        const auto there = [&](double part) {
            const Eigen::AngleAxisd rotation(part * share * angle / count, axis);
            std::vector<Capsule> turned = begin;
            for (Capsule& shape : turned) {
                shape.centre_mm = centre + rotation * (shape.centre_mm - centre);
                shape.half_axis_mm = rotation * shape.half_axis_mm;
            }
            return turned;
        };
        share = sweep_share(begin, there(1.0), surfaces, keep_mm);
        const ToolResistance end = resistance(there(1.0));
        const bool against = end.torque_un_mm.dot(axis) < 0.0;
        share *= share_within(there, end, [&](const ToolResistance& r) {
            return against && r.torque_un_mm.norm() > limit_un_mm;
        });
        const std::vector<Capsule> turned = there(1.0);
        const Eigen::AngleAxisd rotation(share * angle / count, axis);
        for (std::size_t p = 0; p < turned.size(); ++p) {
            ToolPart& part = tool.parts[p];
            part.led_by_mm += turned[p].centre_mm - part.shape.centre_mm;
            part.led_half_axis_mm += turned[p].half_axis_mm - part.shape.half_axis_mm;
            part.shape = turned[p];
            part.opens = rotation * part.opens;
        }
        tool.turn_rad -= share / count * by_rad;
        if (share < 1.0) return;
    }
}

void Way::open(double by_mm) {
    const std::vector<Capsule> begin = tool.shapes();
    double gone = by_mm;
    const auto there = [&](double share) {
        std::vector<Capsule> moved = begin;
        for (std::size_t p = 0; p < moved.size(); ++p)
            moved[p].centre_mm += share * gone * tool.parts[p].opens;
        return moved;
    };
    gone *= sweep_share(begin, there(1.0), surfaces, keep_mm);
    gone *= share_within(there, resistance(there(1.0)), [&](const ToolResistance& r) {
        return by_mm < 0.0 && r.grip_un > tool.force_limit_un;
    });
    tool.opening_mm += gone;
    for (ToolPart& part : tool.parts) {
        part.shape.centre_mm += gone * part.opens;
        part.led_by_mm += gone * part.opens;
    }
}

}  // namespace

bool lead(Tool& tool, const StandingSurfaces& surfaces, double keep_mm, double share, double dt_s,
          const ResistanceAt& resistance) {
    Way way{tool, surfaces, keep_mm, resistance};
    for (ToolPart& part : tool.parts) part.led_half_axis_mm.setZero();
    way.go(share * (tool.target_mm - tool.centre_mm()));
    if (!tool.turn_rad.isZero(0.0)) way.turn(share * tool.turn_rad);
    if (tool.opening_mm != tool.opening_target_mm)
        way.open(share * (tool.opening_target_mm - tool.opening_mm));
    tool.led_over_s = dt_s;
    return tool.speed_mm_per_s() > 0.0;
}

Vec3 turned_after(const Vec3& left_rad, const Vec3& by_rad) {
    if (left_rad.isZero(0.0) && by_rad.norm() <= 2.0 * std::numbers::pi) return by_rad;
    const auto rotation = [](const Vec3& turn) {
        const double angle = turn.norm();
        return angle > 0.0 ? Eigen::Quaterniond(Eigen::AngleAxisd(angle, turn / angle))
                           : Eigen::Quaterniond::Identity();
    };
    const Eigen::AngleAxisd both(rotation(by_rad) * rotation(left_rad));
    return both.angle() * both.axis();
}

}  // namespace hepatica
