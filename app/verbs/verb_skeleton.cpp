// SPDX-License-Identifier: GPL-3.0-or-later
// skeleton: thins a vessel mask and shows how it becomes one voxel wide
// (core/skeleton/unit_width_skeleton.h).
#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "app/command_line.h"
#include "app/output_place.h"
#include "app/verbs/verbs.h"
#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/image/volume_reader.h"
#include "core/skeleton/thinning.h"
#include "core/skeleton/unit_width_skeleton.h"
#include "render/voxel_picture.h"

namespace hepatica {

namespace {

struct SkeletonChoices {
    std::filesystem::path mask;
    std::filesystem::path out;
    std::string method = "queue";
    int reach = 10;
};

constexpr std::array<std::uint8_t, 3> grey{205, 205, 205}, orange{240, 150, 40}, green{60, 170, 75},
    red{215, 45, 40}, blue{60, 110, 215};

std::vector<Index3> voxels_of(const Mask& mask) {
    std::vector<Index3> found;
    for (std::size_t i = 0; i < mask.voxels.size(); ++i)
        if (mask.voxels[i] != 0) found.push_back(mask.grid.index_of(i));
    return found;
}

std::vector<Index3> places(const Grid& grid, const std::vector<std::size_t>& offsets) {
    std::vector<Index3> found;
    for (const std::size_t offset : offsets) found.push_back(grid.index_of(offset));
    return found;
}

// Draws the stages around the largest crowded region: crowded regions, exits, centres, paths,
// result.
void draw_stages(const SkeletonChoices& options, const std::filesystem::path& folder,
                 const Mask& thinned, const UnitWidthStages& stages) {
    const auto largest = std::ranges::max_element(
        stages.regions, {}, [](const CrowdedRegion& r) { return r.voxels.size(); });
    if (largest == stages.regions.end()) return;
    const Grid& grid = thinned.grid;
    const Index3 middle = grid.index_of(largest->centre);
    Index3 low{}, high{};
    for (int a = 0; a < 3; ++a) {
        low[a] = middle[a] - options.reach;
        high[a] = middle[a] + options.reach;
    }
    VoxelGroup crowded{{}, orange}, exits{{}, green}, centres{{}, red}, paths{{}, blue};
    for (const CrowdedRegion& region : stages.regions) {
        const auto append = [&](VoxelGroup& group, const std::vector<std::size_t>& offsets) {
            std::ranges::copy(places(grid, offsets), std::back_inserter(group.voxels));
        };
        append(crowded, region.voxels);
        append(exits, region.exits);
        append(centres, {region.centre});
        for (const auto& path : region.paths) append(paths, path);
    }
    const VoxelGroup skeleton{voxels_of(thinned), grey};
    Mask open = thinned;  // without the crowded voxels, which would hide what is inside them
    for (const CrowdedRegion& region : stages.regions)
        for (const std::size_t offset : region.voxels) open.voxels[offset] = 0;
    const VoxelGroup lines{voxels_of(open), grey};
    const VoxelGroup result{voxels_of(stages.skeleton), grey};
    const auto draw = [&](const char* name, const std::vector<VoxelGroup>& groups) {
        write_png(folder / name, draw_voxels(groups, low, high));
    };
    draw("1_thinned.png", {skeleton});
    draw("2_crowded_regions.png", {skeleton, crowded});
    draw("3_exits.png", {skeleton, crowded, exits});
    draw("4_centres.png", {lines, exits, centres});
    draw("5_paths.png", {lines, paths, exits, centres});
    draw("6_unit_width.png", {result});
}

Json run_skeleton(const SkeletonChoices& options, Job& job) {
    if (!options.out.empty()) require_writable_folder(options.out);
    job.expect_stages(3);
    const Mask mask = read_mask(options.mask, job);
    const auto method =
        options.method == "parallel" ? ThinningMethod::parallel : ThinningMethod::queue;
    job.begin_stage("Thinning");
    const Mask thinned = thin(mask, method, job);
    job.begin_stage("Making the skeleton one voxel wide");
    const UnitWidthStages stages = unit_width_stages(thinned, job);
    std::size_t exits = 0;
    for (const CrowdedRegion& region : stages.regions) exits += region.exits.size();
    if (!options.out.empty() && stages.regions.empty())
        spdlog::warn("the skeleton has no crowded region: there are no stages to draw");
    else if (!options.out.empty())
        write_files_atomically(options.out, [&](const std::filesystem::path& folder) {
            draw_stages(options, folder, thinned, stages);
        });
    return {{"thinned_voxels", voxels_of(thinned).size()},
            {"crowded_points", crowded_point_count(thinned)},
            {"crowded_regions", stages.regions.size()},
            {"exits", exits},
            {"voxels", voxels_of(stages.skeleton).size()},
            {"removable_points", removable_point_count(stages.skeleton)}};
}

}  // namespace

void add_skeleton(CommandLine& line) {
    auto options = std::make_shared<SkeletonChoices>();
    CLI::App& verb =
        line.add_verb("skeleton", "Thin a vessel mask and show how it gets one voxel wide",
                      [options](Job& job) { return run_skeleton(*options, job); });
    verb.add_option("mask", options->mask, "Vessel voxels (NIfTI ...)")->required();
    CLI::Option* out = verb.add_option("--out", options->out, "Folder for a picture of each stage");
    verb.add_option("--method", options->method, "How the mask is thinned")
        ->check(CLI::IsMember({"queue", "parallel"}))
        ->capture_default_str();
    verb.add_option("--reach", options->reach, "Voxels shown around the largest region")
        ->check(CLI::Range(2, 100))
        ->needs(out)
        ->capture_default_str();
}

}  // namespace hepatica
