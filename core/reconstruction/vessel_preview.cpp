// SPDX-License-Identifier: GPL-3.0-or-later
// Measures line strengths once, thresholds them on request, and applies the difference to the usual
// result.
#include "core/reconstruction/vessel_preview.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/image/morphology.h"
#include "core/image/voxel_loop.h"
#include "core/patient/liver_segments.h"
#include "core/segmentation/gaussian_refinement.h"
#include "core/segmentation/vessel_growth.h"

namespace hepatica {

namespace {

constexpr double least_piece_mm3 = 20.0;  // about 10 mm of the thinnest vessels
constexpr double wall_mm = 1.3;  // fitted walls lie at most this far outside accepted voxels

void require_possible(const ThresholdChoice& choice) {
    if (!(choice.line_share >= least_line_share && choice.line_share <= most_line_share))
        throw InputError(number_text(choice.line_share) + " is no share of the usual threshold",
                         "threshold",
                         "Give a number from " + number_text(least_line_share) + " to " +
                             number_text(most_line_share));
    if (choice.refinement_recursions < 0 || choice.refinement_recursions > most_recursions)
        throw InputError(
            std::to_string(choice.refinement_recursions) + " recursions cannot be made",
            "smoothing", "Give a whole number from 0 to " + std::to_string(most_recursions));
}

// Voxels of `a` that `b` lacks.
Mask without(const Mask& a, const Mask& b, const Job& job) {
    Mask left = a;
    for_each_voxel(left.voxels.size(), job, [&](std::size_t i) {
        if (b.voxels[i]) left.voxels[i] = 0;
    });
    return left;
}

// Looks up a mask by the voxel offsets of another grid in the same frame.
class SeenFrom {
  public:
    SeenFrom(const Grid& grid, const Mask& mask)
        : grid_(grid), mask_(mask), same_(same_grid(grid, mask.grid)) {}

    std::uint8_t operator()(std::size_t offset) const {
        if (same_) return mask_.voxels[offset];
        const Index3 at = grid_.index_of(offset);
        return value_at(mask_, grid_.to_mm(at[0], at[1], at[2]));
    }

  private:
    const Grid& grid_;
    const Mask& mask_;
    bool same_;
};

}  // namespace

VesselPreview::VesselPreview(const Volume& ct, const Mask& organs, Job& job) {
    SegmentationOptions options;
    Mask liver = liver_of(organs);
    if (!liver.voxels.empty()) options.liver = std::move(liver);
    liver_ = measure_liver(ct, options, job);
    job.begin_stage("Segmenting the vessels");
    lines_ = in_part(job, 0.0, 0.9, [&] {
        return measure_lines(liver_.tissue, liver_.frame.liver, ct.grid.spacing_mm,
                             least_line_share, job);
    });
    liver_.frame = {};
    liver_.tissue.excess = {};
    usual_ = in_part(job, 0.9, 1.0, [&] { return believed(1.0, job); });
}

Mask VesselPreview::believed(double line_share, Job& job) const {
    return without_others(liver_, believed_lines(lines_, line_share, job), job);
}

// A layer around present vessels is no new vessel: added is only what has a part beyond their
// walls, together with the neck that connects it.
Mask VesselPreview::gained_at(double line_share, const Mask& present, Job& job) const {
    Mask there = usual_;
    const SeenFrom is_present(there.grid, present);
    for_each_voxel(there.voxels.size(), job, [&](std::size_t i) {
        if (is_present(i)) there.voxels[i] = 1;
    });
    const Mask now = believed(line_share, job);
    Mask beyond = without(now, dilate(there, wall_mm, job), job);
    beyond = hysteresis(beyond, beyond, least_piece_mm3, job);
    const double neck_mm = wall_mm + there.grid.spacing_mm.maxCoeff();
    const Mask about = dilate(beyond, neck_mm, job);
    Mask more = without(now, usual_, job);
    for_each_voxel(more.voxels.size(), job, [&](std::size_t i) {
        if (!about.voxels[i]) more.voxels[i] = 0;
    });
    return more;
}

Mask VesselPreview::lost_at(double line_share, Job& job) const {
    const Mask now = believed(line_share, job);
    return without(dilate(without(usual_, now, job), wall_mm, job), dilate(now, wall_mm, job), job);
}

// A lower threshold only adds lines, a higher one only drops some.
Mask VesselPreview::vessels(const Mask& present, const ThresholdChoice& choice, std::uint8_t gained,
                            Job& job) const {
    require_possible(choice);
    const JobPart part(job, 0.0, 1.0);  // its steps report each from the beginning on
    Mask vessels = present;
    if (choice.line_share < 1.0) {
        const Mask more = gained_at(choice.line_share, present, job);
        const SeenFrom comes_in(present.grid, more);
        for_each_voxel(vessels.voxels.size(), job, [&](std::size_t i) {
            if (vessels.voxels[i] == 0 && comes_in(i)) vessels.voxels[i] = gained;
        });
    } else if (choice.line_share > 1.0) {
        const Mask less = lost_at(choice.line_share, job);
        const SeenFrom goes(present.grid, less);
        for_each_voxel(vessels.voxels.size(), job, [&](std::size_t i) {
            if (vessels.voxels[i] != 0 && goes(i)) vessels.voxels[i] = 0;
        });
        // Crumbs are what is left of a piece; what was as small before was meant to be.
        const Mask whole = hysteresis(vessels, vessels, least_piece_mm3, job);
        const Mask lessened = hysteresis(without(present, vessels, job), present, 0.0, job);
        for_each_voxel(vessels.voxels.size(), job, [&](std::size_t i) {
            if (!whole.voxels[i] && lessened.voxels[i]) vessels.voxels[i] = 0;
        });
    }
    return choice.refinement_recursions > 0 ? refine(vessels, choice.refinement_recursions, job)
                                            : vessels;
}

}  // namespace hepatica
