// SPDX-License-Identifier: GPL-3.0-or-later
// A capsule (a sphere where its axis has no length) beside a surface: what of it is near, how far
// the surface may move against it, and how far it may move against the surface. Lengths in mm;
// pure functions. Their cost is that of the boxes of all patches and of the triangles near.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/contact/surface_patches.h"

namespace hepatica {

struct Capsule {
    Vec3 centre_mm = Vec3::Zero();
    Vec3 half_axis_mm = Vec3::Zero();  // from the centre to the middle of one end's ball
    double radius_mm = 0.0;            // > 0

    Segment axis() const { return {centre_mm - half_axis_mm, centre_mm + half_axis_mm}; }
};

// A triangle's nearest point.
struct NearTriangle {
    int triangle = 0;
    std::array<double, 3> weights{};  // of its corners
    double gap_mm = 0.0;              // to the capsule's surface; below 0 within it
    Vec3 normal = Vec3::Zero();       // from the axis to the triangle, of length 1; 0 on the axis
    Vec3 on_axis_mm = Vec3::Zero();
};

// All triangles with a gap below reach_mm, by their number.
std::vector<NearTriangle> near_capsule(const Capsule& capsule, const SurfacePatches& surface,
                                       std::span<const Vec3> positions_mm, double reach_mm);

// The share of the straight motion of all vertices from `from_mm` to `to_mm` on which every
// triangle keeps the gap >= 0 that `kept` returns for its gap at the beginning; none below 0 is
// asked for. 1 where nothing is in the way.
double free_share(const Capsule& capsule, const SurfacePatches& surface,
                  std::span<const Vec3> from_mm, std::span<const Vec3> to_mm,
                  const std::function<double(double gap_mm)>& kept);

// What stands still beside capsules that move.
struct StandingSurface {
    const SurfacePatches& patches;
    std::span<const Vec3> positions_mm;
};
using StandingSurfaces = std::vector<StandingSurface>;

// How far the capsules, which keep their places to each other, go along `motion_mm` past surfaces
// that stand still, straight until a gap falls to keep_mm > 0.
Vec3 approach(std::span<const Capsule> capsules, const StandingSurfaces& surfaces,
              const Vec3& motion_mm, double keep_mm);

// Where they come to when they are led by `motion_mm` along surfaces that stand still: they go
// straight until a gap falls to keep_mm > 0, then slide along what stopped them. What is nearer
// from the beginning comes no nearer.
Vec3 slide(std::span<const Capsule> capsules, const StandingSurfaces& surfaces,
           const Vec3& motion_mm, double keep_mm);

// The share of the way from `from` to `to`, of as many capsules, on which all ends go straight past
// surfaces that stand still, until a gap falls to keep_mm > 0. What is nearer from the beginning
// comes no nearer.
double sweep_share(std::span<const Capsule> from, std::span<const Capsule> to,
                   const StandingSurfaces& surfaces, double keep_mm);

}  // namespace hepatica
