// SPDX-License-Identifier: GPL-3.0-or-later
// What objects of this room hold before anyone has written to them.
#include "tests/support/initial_values.h"

#include <gtest/gtest.h>

#include "core/reconstruction/chosen_vessels.h"
#include "core/reconstruction/detected_vessels.h"
#include "core/reconstruction/from_voxels.h"
#include "core/reconstruction/given_vessels.h"
#include "core/reconstruction/reconstruct.h"
#include "core/reconstruction/reconstruct_parameters.h"
#include "core/reconstruction/remade_case.h"
#include "core/reconstruction/vessel_preview.h"
#include "core/reconstruction/vessel_segmentation.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

TEST(ReconstructionInitialFigures, AreThoseRecorded) {
    test::Figures figures;
    HEPATICA_ADD_INITIAL(figures, MeasuredPieces);
    HEPATICA_ADD_INITIAL(figures, MeasuredLiver);
    HEPATICA_ADD_INITIAL(figures, DetectedVessels);
    HEPATICA_ADD_INITIAL(figures, FromVoxelsOptions);
    HEPATICA_ADD_INITIAL(figures, GivenParts);
    HEPATICA_ADD_INITIAL(figures, VoxelCounts);
    HEPATICA_ADD_INITIAL(figures, VoxelChecks);
    HEPATICA_ADD_INITIAL(figures, VesselLabel);
    HEPATICA_ADD_INITIAL(figures, ReconstructOptions);
    HEPATICA_ADD_INITIAL(figures, Reconstruction);
    HEPATICA_ADD_INITIAL(figures, RemadeCase);
    HEPATICA_ADD_INITIAL(figures, ThresholdChoice);
    HEPATICA_ADD_INITIAL(figures, SegmentationOptions);
    HEPATICA_ADD_INITIAL(figures, ContrastStatistics);
    HEPATICA_ADD_INITIAL(figures, Segmentation);
    test::expect_recorded("reconstruction", "initial", figures);
}

}  // namespace
}  // namespace hepatica
