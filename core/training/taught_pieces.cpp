// SPDX-License-Identifier: GPL-3.0-or-later
// Detects lines in a synthetic patient as the reconstruction does, and compares their pieces with
// the true centrelines.
#include "core/training/taught_pieces.h"

#include "core/phantom/random_patient.h"
#include "core/reconstruction/chosen_vessels.h"
#include "core/reconstruction/detected_vessels.h"
#include "core/tree/extraction/centreline_locator.h"

namespace hepatica {

namespace {

constexpr double tolerance_mm = 2.0;  // the same as SystemScoreOptions::length_tolerance_mm
constexpr std::uint64_t liver_found_every = 3;

}  // namespace

std::vector<float> shares_of_truth(const std::vector<LinePiece>& pieces, const VesselTree& truth) {
    const CentrelineLocator locator(truth);
    std::vector<float> shares;
    for (const LinePiece& piece : pieces) {
        int near = 0;
        for (const Vec3& p : piece.points_mm) near += locator.nearest(p, tolerance_mm) ? 1 : 0;
        shares.push_back(static_cast<float>(near) / static_cast<float>(piece.points_mm.size()));
    }
    return shares;
}

std::vector<TaughtPiece> taught_on(const Phantom& patient, const SegmentationOptions& options,
                                   double line_share, Job& job) {
    const DetectedVessels found =
        detect_in_liver(patient.ct, options, line_share, std::nullopt, job);
    if (!found.detection.evidence) return {};
    const MeasuredPieces measured =
        measured_pieces(found.detection.vessels, found, patient.ct.grid.spacing_mm, job);
    const std::vector<float> shares = shares_of_truth(measured.pieces, patient.tree);
    std::vector<TaughtPiece> taught;
    for (std::size_t i = 0; i < shares.size(); ++i)
        taught.push_back({measured.features[i], shares[i]});
    return taught;
}

SegmentationOptions options_taught_with(std::uint64_t number, const Phantom& patient, Job& job) {
    SegmentationOptions options;
    if (number % liver_found_every != 0) options.liver = sloppy_liver(patient.liver, number, job);
    return options;
}

std::vector<TaughtPiece> taught_by_made(const PatientMaker& make, std::uint64_t number,
                                        double line_share, Job& job) {
    const Phantom patient = make(random_patient(number), job);
    return taught_on(patient, options_taught_with(number, patient, job), line_share, job);
}

std::vector<TaughtPiece> taught_by(std::uint64_t number, double line_share, Job& job) {
    return taught_by_made(make_phantom, number, line_share, job);
}

}  // namespace hepatica
