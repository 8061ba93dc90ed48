// SPDX-License-Identifier: GPL-3.0-or-later
// A capsule (a sphere where its axis has zero length) beside a surface: which triangles are near,
// how far the surface may move past the capsule, and how far the capsule past the surface. Lengths
// in mm; pure functions. They cost the boxes of all patches and the triangles near the capsule.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/contact/surface_patches.h"

namespace hepatica {

struct Capsule {
    Vec3 centre_mm = Vec3::Zero();
    Vec3 half_axis_mm = Vec3::Zero();  // from the centre to the centre of one end's sphere
    double radius_mm = 0.0;            // > 0

    Segment axis() const { return {centre_mm - half_axis_mm, centre_mm + half_axis_mm}; }
};

// The point of a triangle nearest to a capsule.
struct NearTriangle {
    int triangle = 0;
    std::array<double, 3> weights{};  // of its corners
    double gap_mm = 0.0;              // to the capsule's surface; negative inside
    Vec3 normal = Vec3::Zero();       // from the axis to the triangle, of length 1; 0 on the axis
    Vec3 on_axis_mm = Vec3::Zero();
};

// All triangles with a gap below reach_mm, in ascending order.
std::vector<NearTriangle> near_capsule(const Capsule& capsule, const SurfacePatches& surface,
                                       std::span<const Vec3> positions_mm, double reach_mm);

// The share of the straight motion of all vertices from `from_mm` to `to_mm` during which every
// triangle keeps the gap that `kept` returns for its gap at the start; a negative value means that
// no gap is required. 1 where nothing is in the way.
double free_share(const Capsule& capsule, const SurfacePatches& surface,
                  std::span<const Vec3> from_mm, std::span<const Vec3> to_mm,
                  const std::function<double(double gap_mm)>& kept);

// A fixed surface beside moving capsules.
struct StandingSurface {
    const SurfacePatches& patches;
    std::span<const Vec3> positions_mm;
};
using StandingSurfaces = std::vector<StandingSurface>;

// How far the capsules, as one rigid body, can move straight along `motion_mm` past fixed surfaces
// until a gap falls to keep_mm > 0.
Vec3 approach(std::span<const Capsule> capsules, const StandingSurfaces& surfaces,
              const Vec3& motion_mm, double keep_mm);

// The displacement of the capsules, as one rigid body, when they are led by `motion_mm` past fixed
// surfaces: straight until a gap falls to keep_mm > 0, then sliding along what stopped them.
// Triangles that are nearer at the start do not come nearer.
Vec3 slide(std::span<const Capsule> capsules, const StandingSurfaces& surfaces,
           const Vec3& motion_mm, double keep_mm);

// The share of the motion from `from` to `to` (equally many capsules) during which all ends can
// move straight past fixed surfaces until a gap falls to keep_mm > 0. Triangles that are nearer at
// the start do not come nearer.
double sweep_share(std::span<const Capsule> from, std::span<const Capsule> to,
                   const StandingSurfaces& surfaces, double keep_mm);

}  // namespace hepatica
