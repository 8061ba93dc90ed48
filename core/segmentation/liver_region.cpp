// SPDX-License-Identifier: GPL-3.0-or-later
// Coarsening, soft organ, parenchyma, neighbours, border and closing, one after the other.
#include "core/segmentation/liver_region.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/image/filters.h"
#include "core/image/morphology.h"
#include "core/segmentation/enclosed_tissue.h"
#include "core/segmentation/liver_neighbours.h"
#include "core/segmentation/organ_border.h"
#include "core/segmentation/organ_surroundings.h"
#include "core/segmentation/parenchyma.h"
#include "core/segmentation/soft_organ.h"

namespace hepatica {

namespace {

constexpr double organ_smoothing_mm = 3.0;   // to find the organ
constexpr double border_smoothing_mm = 2.0;  // to find its border
constexpr double beyond_core_mm = 60.0;      // how far the liver may extend beyond its core
constexpr double smallest_core_ml = 40.0;
constexpr double vessel_closing_mm = 9.0;

// Costs of the border, tuned on synthetic bodies (tests/segmentation/random_abdomen.h). A voxel of
// the parenchyma's intensity is worth 0.6 faces of surface.
constexpr double data_weight = 0.6;
constexpr double even_spreads = 2.4;  // where inside and outside are equally likely
constexpr double most_dark = 2.0;
constexpr double most_bright = 0.6;  // low, because vessels are bright too
constexpr double foreign_cost = 2.0;
constexpr double supported_from = 0.01;
constexpr double edge_hu_per_mm = 4.0;
constexpr double least_area = 0.02;
// Between these differences from the parenchyma a voxel on a slope may be a mixture of two tissues,
// so its intensity counts less.
constexpr double mixture_from_hu = -80.0, mixture_to_hu = 100.0;
constexpr double bright_spreads = 4.0, bright_radius_mm = 8.0;  // kidneys, heart chambers
constexpr double leash_mm = 8.0;  // largest distance of the border from the parenchyma
constexpr double neighbour_rim_mm = 3.0;
constexpr int border_iterations = 80;
constexpr std::size_t cost_block = 8192;

void remove(const Mask& what, Mask& from) {
    for (std::size_t i = 0; i < from.voxels.size(); ++i)
        if (what.voxels[i] != 0) from.voxels[i] = 0;
}

void unite(Mask& mask, const Mask& with) {
    for (std::size_t i = 0; i < mask.voxels.size(); ++i)
        if (with.voxels[i]) mask.voxels[i] = 1;
}

// Regions brighter than the liver and wider than its vessels.
Mask bright_bodies(const FloatVolume& smooth, const Parenchyma& tissue, Job& job) {
    Mask bright(smooth.grid);
    const auto rise = static_cast<float>(bright_spreads * tissue.spread_hu);
    for (std::size_t i = 0; i < bright.voxels.size(); ++i)
        bright.voxels[i] = smooth.voxels[i] > tissue.hu.voxels[i] + rise;
    return open(bright, bright_radius_mm, job);
}

// Cost of taking a voxel inside (negative: gain), by its intensity. It counts less the steeper the
// image is there (`edge` is 1 where flat, towards 0 at an edge).
double inside_cost(double above_hu, double support, double spread_hu, double edge) {
    const double spreads = above_hu / (even_spreads * spread_hu);
    double cost = support < supported_from ? foreign_cost
                                           : std::clamp(spreads * spreads - 1.0, -1.0,
                                                        above_hu > 0.0 ? most_bright : most_dark);
    if (above_hu > mixture_from_hu && above_hu < mixture_to_hu) cost *= edge;
    return data_weight * cost;
}

BorderCost border_cost(const FloatVolume& smooth, const Parenchyma& tissue, const Mask& neighbours,
                       Job& job) {
    const Mask bright = bright_bodies(smooth, tissue, job);
    const Mask reached = dilate(tissue.voxels, leash_mm, job);
    const Mask foreign = erode(neighbours, neighbour_rim_mm, job);
    BorderCost cost{FloatVolume(smooth.grid), FloatVolume(smooth.grid)};
    parallel_blocks(smooth.voxels.size(), cost_block, [&](std::size_t begin, std::size_t end) {
        job.throw_if_cancelled();
        for (std::size_t i = begin; i < end; ++i) {
            const auto [x, y, z] = smooth.grid.index_of(i);
            const double steepness =
                static_cast<double>(slope_at(smooth, x, y, z)) / edge_hu_per_mm;
            const double edge = 1.0 / (1.0 + steepness * steepness);
            const bool outside =
                bright.voxels[i] != 0 || reached.voxels[i] == 0 || foreign.voxels[i] != 0;
            cost.inside.voxels[i] = static_cast<float>(
                outside ? data_weight * foreign_cost
                        : inside_cost(static_cast<double>(smooth.voxels[i] - tissue.hu.voxels[i]),
                                      static_cast<double>(tissue.support.voxels[i]),
                                      tissue.spread_hu, edge));
            cost.area.voxels[i] = static_cast<float>(edge + least_area);
        }
    });
    return cost;
}

// The liver around its core, all on one grid.
Mask liver_about(const Mask& core, const FloatVolume& smooth, Job& job) {
    const Mask seat = in_part(job, 0.0, 0.05, [&] { return seat_of(core, job); });
    Parenchyma tissue = in_part(job, 0.05, 0.5, [&] { return grow_parenchyma(smooth, seat, job); });
    const Mask neighbours = in_part(job, 0.5, 0.6, [&] {
        return neighbours_in(tissue.voxels, enclosed_tissue(smooth, tissue.voxels, job), seat, job);
    });
    remove(neighbours, tissue.voxels);
    Mask liver = in_part(job, 0.6, 0.8, [&] {
        return fit_border(border_cost(smooth, tissue, neighbours, job), tissue.voxels,
                          border_iterations, job);
    });
    liver = largest_components(liver, Connectivity::faces6);
    const JobPart rest(job, 0.8, 1.0);
    unite(liver, enclosed_tissue(smooth, liver, job));
    return close_liver(liver, vessel_closing_mm, job);
}

}  // namespace

Mask close_liver(const Mask& liver, double radius_mm, Job& job) {
    Mask closed = close(liver, radius_mm, job);
    unite(closed, liver);
    return fill_holes(closed, job);
}

FoundLiver find_liver(const Volume& ct, Job& job) {
    const FloatVolume coarse = coarsened(ct, job);
    FloatVolume smooth = coarse;
    in_part(job, 0.0, 0.1,
            [&] { gaussian_smooth(smooth, Vec3::Constant(organ_smoothing_mm), job); });
    const SoftOrgan organ = in_part(job, 0.1, 0.3, [&] { return largest_soft_organ(smooth, job); });
    if (organ.core_ml < smallest_core_ml)
        throw NoLiverFound("no liver was found: the largest soft organ between " +
                               std::to_string(static_cast<int>(soft_organ_from_hu)) + " and " +
                               std::to_string(static_cast<int>(soft_organ_to_hu)) + " HU has " +
                               std::to_string(static_cast<int>(organ.core_ml)) + " ml",
                           "CT", "Check that the scan shows the liver, or give a liver mask.");
    const IndexBox box = grow_box(bounding_box(organ.core), coarse.grid, beyond_core_mm);
    FloatVolume near = crop(coarse, box);
    in_part(job, 0.3, 0.35,
            [&] { gaussian_smooth(near, Vec3::Constant(border_smoothing_mm), job); });
    Mask liver(coarse.grid);
    paste(in_part(job, 0.35, 0.85, [&] { return liver_about(crop(organ.core, box), near, job); }),
          box.begin, liver);
    require_surroundings_of_liver(
        in_part(job, 0.85, 0.9, [&] { return surroundings_of(liver, smooth, job); }));
    const JobPart rest(job, 0.9, 1.0);
    const Mask alike = close_liver(with_all_alike(organ, smooth, job), vessel_closing_mm, job);
    return {resample(liver, ct.grid, Interpolation::linear, job),
            resample(alike, ct.grid, Interpolation::linear, job)};
}

}  // namespace hepatica
