// SPDX-License-Identifier: GPL-3.0-or-later
// A small patient whose vessels tear and bleed, and a blade's way across its trunk.
#pragma once

#include <memory>

#include "tests/session/new_session.h"

namespace hepatica::test {

inline SceneSpec that_tears() {
    SceneSpec spec = default_scene();
    spec.tear.emplace();
    return spec;
}

// Along a blade's way across the first branch, well beyond both sides.
inline Blade blade() {
    const auto& points = small_patient()->tree.segments[0].points_mm;
    const std::size_t m = points.size() / 2;
    const Vec3 across = 15.0 * (points[m + 1] - points[m - 1]).unitOrthogonal();
    return {points[m] - across, points[m] + across};
}

// Vessels of a system that is supplied bleed.
inline std::unique_ptr<Session> of_portal_veins() {
    auto patient = std::make_shared<PatientCase>(*small_patient());
    for (VesselSegment& segment : patient->tree.segments) segment.system = VascularSystem::portal;
    Job job;
    return std::make_unique<Session>(patient, that_tears(), job);
}

}  // namespace hepatica::test
