// SPDX-License-Identifier: GPL-3.0-or-later
// The rigid motion with the linear and angular momentum of some nodes, and how nodes continue by it
// for a step.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/vector.h"

namespace hepatica {

struct RigidMotion {
    Vec3 centre_mm, velocity_mm_per_s, spin_per_s;
    double spin_energy_nj, flight_energy_nj;
    Vec3 of_spin(const Vec3& x) const { return spin_per_s.cross(Vec3(x - centre_mm)); }
    Vec3 operator()(const Vec3& x) const { return velocity_mm_per_s + of_spin(x); }
};

// Requires at least one node; masses [g] > 0, positions [mm] and velocities [mm/s] are those of all
// nodes of a body. The spin about an axis without inertia (nodes in a line) is zero.
RigidMotion rigid_motion(std::span<const int> nodes, std::span<const double> mass_g,
                         std::span<const Vec3> positions_mm,
                         std::span<const Vec3> velocities_mm_per_s);

// For each node, the constant velocity that brings it in `dt_s` > 0 to where the rigid motion
// carries it. The shape of the nodes is kept, their momentum is that of the motion, and their
// kinetic energy is at most that of the motion. A rotation is limited to one radian.
std::vector<Vec3> straight_ways(const RigidMotion& motion, std::span<const int> nodes,
                                std::span<const Vec3> positions_mm, double dt_s);

// The velocity of the centre of mass, for every node. It keeps the momentum of a body that is about
// to collide with itself, and no surfaces meet. None where a node is held (not 0).
std::optional<std::vector<Vec3>> common_velocity(std::span<const double> mass_g,
                                                 std::span<const std::uint8_t> held,
                                                 std::span<const Vec3> velocities_mm_per_s);

}  // namespace hepatica
