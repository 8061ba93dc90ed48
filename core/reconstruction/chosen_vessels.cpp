// SPDX-License-Identifier: GPL-3.0-or-later
// Skeletonises the detected vessels, measures pieces of the skeleton and removes those that the
// model drops.
#include "core/reconstruction/chosen_vessels.h"

#include <algorithm>

#include "core/links/piece_choice.h"
#include "core/segmentation/vessel_growth.h"
#include "core/skeleton/thinning.h"
#include "core/skeleton/unit_width_skeleton.h"

namespace hepatica {

namespace {

constexpr double longest_piece_mm = 8.0;
constexpr double least_rise_hu = 1.0;  // least rise assumed for wide vessels, where hardly any
                                       // stand out

}  // namespace

MeasuredPieces measured_pieces(const DetectedVessels& found, const Vec3& ct_spacing_mm, Job& job) {
    const Mask& vessels = found.detection.vessels;
    const Mask lines =
        in_part(job, 0.0, 0.15, [&] { return thin(vessels, ThinningMethod::queue, job); });
    const Mask skeleton = in_part(job, 0.15, 0.3, [&] { return unit_width(lines, job); });
    MeasuredPieces measured{line_pieces(skeleton, vessels, longest_piece_mm), {}};
    const double contrast_hu =
        in_part(job, 0.3, 0.5, [&] { return contrast_of(found, job).contrast_hu(); });
    const double rise_hu = std::max(contrast_hu, least_rise_hu);
    const JobPart rest(job, 0.5, 1.0);
    measured.features =
        piece_features(measured.pieces,
                       {*found.detection.evidence, found.frame.liver, ct_spacing_mm, rise_hu}, job);
    return measured;
}

void keep_chosen(const LinkModel& model, const Vec3& ct_spacing_mm, DetectedVessels& found,
                 Job& job) {
    job.begin_stage("Choosing the vessels");
    const MeasuredPieces measured =
        in_part(job, 0.0, 0.8, [&] { return measured_pieces(found, ct_spacing_mm, job); });
    std::vector<double> shares;
    for (const PieceFeatures& features : measured.features)
        shares.push_back(model.forest.share_of_vessel(features));
    const std::vector<std::uint8_t> chosen =
        chosen_pieces(measured.pieces, shares, model.kept_share);
    if (std::ranges::find(chosen, 0) == chosen.end()) return;
    Mask& vessels = found.detection.vessels;
    vessels = without_dropped(vessels, measured.pieces, chosen, job);
    vessels = hysteresis(vessels, vessels, smallest_vessel_mm3, job);
}

}  // namespace hepatica
