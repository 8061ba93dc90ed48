// SPDX-License-Identifier: GPL-3.0-or-later
// bench region: cost of a frame that computes only the live region, in a small and a large tree
// (core/study/region_study.h).
#include <memory>

#include "app/verbs/verbs.h"
#include "core/scene/deform_part.h"
#include "core/study/region_study.h"

namespace hepatica {

void add_bench_region(CommandLine& line) {
    const auto options = std::make_shared<RegionStudyOptions>();
    options->tether_pa_per_mm2 = DeformSpec{}.tether_pa_per_mm2;
    options->region = DeformPart::region;
    CLI::App& verb = line.add_verb(
        "bench", "Benchmarks", "region",
        "A frame's cost in a small and a large patient with the same twig held",
        [options](Job& job) {
            const std::vector<RegionRow> measured = study_region(*options, job);
            Json rows = Json::array();
            for (const RegionRow& row : measured) {
                rows.push_back({{"tetrahedra", row.tetrahedra},
                                {"live_tetrahedra", row.live_tetrahedra},
                                {"whole_ms", row.whole_ms},
                                {"live_ms", row.live_ms},
                                {"live_longest_ms", row.live_longest_ms},
                                {"difference_mm", row.difference_mm},
                                {"rms_difference", row.rms_difference}});
            }
            return Json{{"tether_pa_per_mm2", options->tether_pa_per_mm2},
                        {"wake_radii", options->region.wake_radii},
                        {"still_radii_per_s", options->region.still_radii_per_s},
                        {"rows", rows},
                        {"cost_ratio", measured.back().live_ms / measured.front().live_ms}};
        });
    verb.add_option("--frames", options->frames, "Frames of 1/60 s in which the twig is held")
        ->check(CLI::Range(1, 100000));
    verb.add_option("--frames-after", options->frames_after, "Frames after it is let go")
        ->check(CLI::Range(0, 100000));
    verb.add_option("--tether-pa-per-mm2", options->tether_pa_per_mm2,
                    "Pull of the surrounding tissue; by default a scene's")
        ->check(CLI::Range(0.0, 1e9));
    verb.add_option("--wake-radii", options->region.wake_radii,
                    "Strain at the border that wakes a stretch; by default a scene's")
        ->check(CLI::Range(1e-9, 1.0));
    verb.add_option("--still-radii-per-s", options->region.still_radii_per_s,
                    "Speed below which a stretch freezes; by default a scene's")
        ->check(CLI::Range(1e-9, 10.0));
    verb.add_option("--generations", options->generations,
                    "Of each tree's forks; the twigs are alike")
        ->check(CLI::Range(1, 8));
}

}  // namespace hepatica
