// SPDX-License-Identifier: GPL-3.0-or-later
// What a frame costs in a small and in a large patient when the same twig is led around in both.
#pragma once

#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/deform/live_region.h"

namespace hepatica {

struct RegionRow {
    int tetrahedra = 0;
    int live_tetrahedra = 0;       // most of any frame
    double whole_ms = 0.0;         // median frame, everything computed
    double live_ms = 0.0;          // median frame, only what the scene requires
    double live_longest_ms = 0.0;  // with the region's change in it
    double difference_mm = 0.0;    // largest between the two at the end, for a pull by 2 mm
};

struct RegionStudyOptions {
    int frames = 120;                    // of 1/60 s
    double tether_pa_per_mm2 = 1000.0;   // of the tissue around
    LiveRegionOptions region{};          // thresholds; a scene's are DeformPart::region
    std::vector<int> generations{4, 7};  // of the trees; twigs are alike
};

std::vector<RegionRow> study_region(const RegionStudyOptions& options, Job& job);

}  // namespace hepatica
