// SPDX-License-Identifier: GPL-3.0-or-later
// What a frame costs in a small and in a large patient when the same twig is led around and let go
// in both, and what leaving the rest out misses.
#pragma once

#include <vector>

#include "core/base/job.h"
#include "core/deform/stepper/live_region.h"

namespace hepatica {

struct RegionRow {
    int tetrahedra = 0;
    int live_tetrahedra = 0;       // most of any frame
    double whole_ms = 0.0;         // median frame while held, everything computed
    double live_ms = 0.0;          // median frame while held, only what the scene requires
    double live_longest_ms = 0.0;  // with the region's change in it
    double difference_mm = 0.0;    // largest between the two of any frame, for a pull by 2 mm
    double rms_difference = 0.0;   // over frames and vertices, relative to that of the motion
};

struct RegionStudyOptions {
    int frames = 120;                    // of 1/60 s, the twig held
    int frames_after = 60;               // let go: in the differences, not in the times
    double tether_pa_per_mm2 = 1000.0;   // of the tissue around
    LiveRegionOptions region{};          // thresholds; a scene's are DeformPart::region
    std::vector<int> generations{4, 7};  // of the trees; twigs are alike
};

std::vector<RegionRow> study_region(const RegionStudyOptions& options, Job& job);

}  // namespace hepatica
