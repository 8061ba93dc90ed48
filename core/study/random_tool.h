// SPDX-License-Identifier: GPL-3.0-or-later
// Tools of random size that approach a body from a random side, and random goals of their way, for
// the campaigns of the stability suite.
#pragma once

#include <random>
#include <span>
#include <string>

#include "core/deform/body/body.h"
#include "core/deform/potentials/tool.h"

namespace hepatica {

// A unit vector; draws three numbers or more.
Vec3 random_direction(std::mt19937_64& random);

// One of these points, of which there must be one at least.
Vec3 random_point(std::span<const Vec3> points_mm, std::mt19937_64& random);

// The mean of the vertices, and the distance of the furthest one from it.
struct BodyExtent {
    Vec3 middle_mm = Vec3::Zero();
    double reach_mm = 0.0;
};
BodyExtent extent_of(const BodyDescription& body);

// A tool of this kind (ToolChoice::kind) far enough away to touch nothing, on its way to the middle
// of the body. Draws its radius, its length unless it is a sphere, and its direction, in this
// order.
Tool random_tool(const std::string& kind, const BodyDescription& body, const BodyExtent& extent,
                 std::mt19937_64& random);

}  // namespace hepatica
