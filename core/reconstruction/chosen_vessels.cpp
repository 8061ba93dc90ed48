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
constexpr double kept_share_of_piece = 0.9;  // of its points that lie in the vessels
constexpr double least_rise_hu = 1.0;  // least rise assumed for wide vessels, where hardly any
                                       // stand out

std::vector<double> shares_of(const MeasuredPieces& measured, const LinkModel& model) {
    std::vector<double> shares;
    for (const PieceFeatures& features : measured.features)
        shares.push_back(model.forest.share_of_vessel(features));
    return shares;
}

bool lies_in(const LinePiece& piece, const Mask& vessels) {
    const auto inside = std::ranges::count_if(piece.points_mm, [&](const Vec3& point_mm) {
        const auto voxel = voxel_at(vessels.grid, point_mm);
        return voxel && vessels.at((*voxel)[0], (*voxel)[1], (*voxel)[2]) != 0;
    });
    return static_cast<double>(inside) >=
           kept_share_of_piece * static_cast<double>(piece.points_mm.size());
}

}  // namespace

MeasuredPieces measured_pieces(const Mask& lines, const DetectedVessels& found,
                               const Vec3& ct_spacing_mm, Job& job) {
    const Mask thinned =
        in_part(job, 0.0, 0.15, [&] { return thin(lines, ThinningMethod::queue, job); });
    const Mask skeleton = in_part(job, 0.15, 0.3, [&] { return unit_width(thinned, job); });
    MeasuredPieces measured{line_pieces(skeleton, lines, longest_piece_mm), {}};
    const double contrast_hu =
        in_part(job, 0.3, 0.5, [&] { return contrast_of(found, job).contrast_hu(); });
    const double rise_hu = std::max(contrast_hu, least_rise_hu);
    const JobPart rest(job, 0.5, 1.0);
    measured.features =
        piece_features(measured.pieces,
                       {*found.detection.evidence, found.frame.liver, ct_spacing_mm, rise_hu}, job);
    return measured;
}

std::vector<Bridge> keep_chosen(const LinkModel& model, const Vec3& ct_spacing_mm,
                                DetectedVessels& found, Job& job) {
    job.begin_stage("Choosing the vessels");
    const MeasuredPieces measured = in_part(job, 0.0, 0.8, [&] {
        return measured_pieces(found.detection.vessels, found, ct_spacing_mm, job);
    });
    const std::vector<double> shares = shares_of(measured, model);
    const std::vector<std::uint8_t> chosen =
        chosen_pieces(measured.pieces, shares, model.kept_share);
    if (std::ranges::find(chosen, 0) == chosen.end()) return {};
    Mask& vessels = found.detection.vessels;
    vessels = without_dropped(vessels, measured.pieces, chosen, job);
    vessels = hysteresis(vessels, vessels, smallest_vessel_mm3, job);
    return offered_branches(measured.pieces, shares, chosen);
}

std::vector<Bridge> doubtful_branches(const LinkModel& model, const Vec3& ct_spacing_mm,
                                      const DetectedVessels& found, const Mask& vessels, Job& job) {
    job.begin_stage("Looking for doubtful branches");
    const MeasuredPieces measured =
        measured_pieces(found.detection.doubtful, found, ct_spacing_mm, job);
    std::vector<std::uint8_t> kept;
    for (const LinePiece& piece : measured.pieces) kept.push_back(lies_in(piece, vessels) ? 1 : 0);
    return offered_branches(measured.pieces, shares_of(measured, model), kept);
}

}  // namespace hepatica
