// SPDX-License-Identifier: GPL-3.0-or-later
// The cost of a frame in a small and in a large patient when the same twig is led around and let go
// in both, and the error of not computing the rest.
#pragma once

#include <vector>

#include "core/base/job.h"
#include "core/deform/stepper/live_region.h"

namespace hepatica {

struct RegionRow {
    int tetrahedra = 0;
    int live_tetrahedra = 0;       // most of any frame
    double whole_ms = 0.0;         // median frame while held, everything computed
    double live_ms = 0.0;          // median frame while held, only the live region
    double live_longest_ms = 0.0;  // includes changes of the region
    double difference_mm = 0.0;   // largest between both, for a pull around a circle of 2 mm radius
    double rms_difference = 0.0;  // over frames and vertices, relative to the motion
};

struct RegionStudyOptions {
    int frames = 120;                   // of 1/60 s, twig held
    int frames_after = 60;              // twig let go; counted in the differences, not in the times
    double tether_pa_per_mm2 = 1000.0;  // of the surrounding tissue
    LiveRegionOptions region{};         // thresholds; a scene's are DeformPart::region
    std::vector<int> generations{4, 7};  // of the trees; twigs are alike
};

// Announces and begins a stage per tree. Throws Cancelled.
std::vector<RegionRow> study_region(const RegionStudyOptions& options, Job& job);

}  // namespace hepatica
