// SPDX-License-Identifier: GPL-3.0-or-later
// A small patient for tests of scenes and sessions: seven branches, some two thousand tetrahedra.
#pragma once

#include <memory>

#include "core/mesh/surface.h"
#include "core/mesh/tetrahedralize.h"
#include "core/patient/patient_case.h"
#include "tests/mesh/random_tree.h"

namespace hepatica::test {

inline std::shared_ptr<const PatientCase> small_patient() {
    static const std::shared_ptr<const PatientCase> patient = [] {
        auto made = std::make_shared<PatientCase>();
        Job job;
        made->tree = random_tree(5, 3, 4.0);
        made->mesh = tetrahedralize(made->tree, {}, job);
        made->surface = surface_of(made->mesh).mesh;
        return made;
    }();
    return patient;
}

// The middle of a segment's centreline.
inline Vec3 middle_of(const VesselTree& tree, int segment) {
    const auto& points = tree.segments[segment].points_mm;
    return points[points.size() / 2];
}

}  // namespace hepatica::test
