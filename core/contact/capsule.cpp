// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/capsule.h"

#include <algorithm>
#include <cmath>

#include "core/contact/time_of_contact.h"

namespace hepatica {
namespace {

constexpr double tolerance = 1e-3;  // relative to the gap to be kept, or to the gap at the start
constexpr int most_slides = 5;

Box box_around(const Segment& axis, double margin_mm) {
    Box box;
    for (const Vec3& end : axis) box.add(end);
    box.grow(margin_mm);
    return box;
}

Segment moved(const Segment& axis, const Vec3& by_mm) {
    return {axis[0] + by_mm, axis[1] + by_mm};
}

NearTriangle nearest_point(const Segment& axis, double radius_mm, const Triangle& corners,
                           int triangle) {
    const SegmentTriangle on = closest(axis, corners);
    NearTriangle near{triangle, on.weights, std::sqrt(on.squared_mm2) - radius_mm, Vec3::Zero(),
                      point_at(axis, on.along)};
    if (on.squared_mm2 > 0.0)
        near.normal = (point_at(corners, on.weights) - near.on_axis_mm) / std::sqrt(on.squared_mm2);
    return near;
}

// The share of a motion until it is stopped, and the normal of what stops it, pointing away from
// it.
struct Stop {
    double share = 1.0;
    Vec3 normal = Vec3::Zero();
};

// Stops one capsule, the ends of whose axis move by `steps`. Triangles that are nearer than keep_mm
// at the start may not come nearer. `stop` changes only where something stops the capsule earlier.
void stop_one(const Segment& axis, const Segment& steps, double radius_mm,
              const StandingSurface& surface, double keep_mm, Stop& stop) {
    constexpr double band = tolerance * tolerance;
    const Motion<Segment> motion{axis, {axis[0] + steps[0], axis[1] + steps[1]}};
    Box box;
    for (const Segment& ends : {motion.begin, motion.end})
        for (const Vec3& end : ends) box.add(end);
    box.grow(radius_mm + keep_mm);
    const auto& [patches, positions_mm] = surface;
    for (const int t : patches.triangles_in(box, positions_mm)) {
        const Triangle corners = corners_of(patches.triangles()[t], positions_mm);
        const double gap = nearest_point(axis, radius_mm, corners, t).gap_mm;
        const double keep = std::min(keep_mm, gap) - band * keep_mm;
        const Motion<Triangle> still{corners, corners};
        const auto time = time_of_contact(motion, still, radius_mm + keep, band * keep_mm);
        if (!time || *time >= stop.share) continue;
        const Segment there{axis[0] + *time * steps[0], axis[1] + *time * steps[1]};
        stop = {*time, -nearest_point(there, radius_mm, corners, t).normal};
    }
}

// Stops all capsules, displaced by `begin_mm` and then moving by `motion_mm`.
Stop straight(std::span<const Capsule> capsules, const Vec3& begin_mm,
              const StandingSurfaces& surfaces, const Vec3& motion_mm, double keep_mm) {
    Stop stop;
    for (const StandingSurface& surface : surfaces)
        for (const Capsule& capsule : capsules)
            stop_one(moved(capsule.axis(), begin_mm), {motion_mm, motion_mm}, capsule.radius_mm,
                     surface, keep_mm, stop);
    return stop;
}

// The part of a motion that goes against none of these normals; zero where there is none, as in a
// corner.
Vec3 along_all(Vec3 motion, const std::vector<Vec3>& normals) {
    for (int round = 0; round < 2; ++round)
        for (const Vec3& n : normals) motion -= std::min(0.0, motion.dot(n)) * n;
    const auto against = [&](const Vec3& n) { return motion.dot(n) < -1e-9 * motion.norm(); };
    return std::ranges::any_of(normals, against) ? Vec3(Vec3::Zero()) : motion;
}

}  // namespace

std::vector<NearTriangle> near_capsule(const Capsule& capsule, const SurfacePatches& surface,
                                       std::span<const Vec3> positions_mm, double reach_mm) {
    std::vector<NearTriangle> near;
    const Segment axis = capsule.axis();
    const Box box = box_around(axis, capsule.radius_mm + reach_mm);
    for (const int t : surface.triangles_in(box, positions_mm)) {
        const Triangle corners = corners_of(surface.triangles()[t], positions_mm);
        const NearTriangle candidate = nearest_point(axis, capsule.radius_mm, corners, t);
        if (candidate.gap_mm < reach_mm) near.push_back(candidate);
    }
    return near;
}

double free_share(const Capsule& capsule, const SurfacePatches& surface,
                  std::span<const Vec3> from_mm, std::span<const Vec3> to_mm,
                  const std::function<double(double gap_mm)>& kept) {
    const Segment axis = capsule.axis();
    const Motion<Segment> still{axis, axis};
    const Box box = box_around(axis, capsule.radius_mm);
    double share = 1.0;
    const auto look_at = [&](int t) {
        const Motion<Triangle> motion{corners_of(surface.triangles()[t], from_mm),
                                      corners_of(surface.triangles()[t], to_mm)};
        const double gap = nearest_point(axis, capsule.radius_mm, motion.begin, t).gap_mm;
        const double keep = kept(gap);
        if (keep < 0.0) return;
        double band = tolerance * std::max(gap - keep, keep);
        if (keep > 0.0) band = std::min(band, keep);
        const auto time = time_of_contact(still, motion, capsule.radius_mm + keep, band);
        if (time) share = std::min(share, *time);
    };
    for (std::size_t p = 0; p < surface.size(); ++p) {
        Box swept = surface.box(p, from_mm);
        const Box end = surface.box(p, to_mm);
        swept.add(end.low);
        swept.add(end.high);
        // Grows the box by the largest gap that may have to be kept.
        swept.grow(std::max(0.0, kept(INFINITY)));
        if (!swept.meets(box)) continue;
        for (const int t : surface.triangles_of(p)) look_at(t);
    }
    return share;
}

Vec3 approach(std::span<const Capsule> capsules, const StandingSurfaces& surfaces,
              const Vec3& motion_mm, double keep_mm) {
    return straight(capsules, Vec3::Zero(), surfaces, motion_mm, keep_mm).share * motion_mm;
}

Vec3 slide(std::span<const Capsule> capsules, const StandingSurfaces& surfaces,
           const Vec3& motion_mm, double keep_mm) {
    Vec3 gone = Vec3::Zero(), left = motion_mm;
    std::vector<Vec3> normals;  // of what stopped the capsules
    for (int round = 0; round < most_slides && !left.isZero(0.0); ++round) {
        const Stop stop = straight(capsules, gone, surfaces, left, keep_mm);
        gone += stop.share * left;
        left *= 1.0 - stop.share;
        if (stop.share == 1.0) break;
        normals.push_back(stop.normal);
        left = along_all(left, normals);
    }
    return gone;
}

double sweep_share(std::span<const Capsule> from, std::span<const Capsule> to,
                   const StandingSurfaces& surfaces, double keep_mm) {
    Stop stop;
    for (const StandingSurface& surface : surfaces)
        for (std::size_t i = 0; i < from.size(); ++i) {
            const Segment begin = from[i].axis(), end = to[i].axis();
            stop_one(begin, {end[0] - begin[0], end[1] - begin[1]}, from[i].radius_mm, surface,
                     keep_mm, stop);
        }
    return stop.share;
}

}  // namespace hepatica
