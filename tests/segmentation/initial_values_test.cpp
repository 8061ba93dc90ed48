// SPDX-License-Identifier: GPL-3.0-or-later
// What objects of this room hold before anyone has written to them.
#include "tests/support/initial_values.h"

#include <gtest/gtest.h>

#include "core/segmentation/gaussian_refinement.h"
#include "core/segmentation/hilum_vessels.h"
#include "core/segmentation/line_coherence.h"
#include "core/segmentation/liver_frame.h"
#include "core/segmentation/liver_region.h"
#include "core/segmentation/minimal_surface.h"
#include "core/segmentation/organ_border.h"
#include "core/segmentation/organ_lobes.h"
#include "core/segmentation/organ_surroundings.h"
#include "core/segmentation/parenchyma.h"
#include "core/segmentation/soft_organ.h"
#include "core/segmentation/tissue_contrast.h"
#include "core/segmentation/vessel_detection.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

TEST(SegmentationInitialFigures, AreThoseRecorded) {
    test::Figures figures;
    HEPATICA_ADD_INITIAL(figures, RefinementOptions);
    HEPATICA_ADD_INITIAL(figures, SurfaceMeasure);
    HEPATICA_ADD_INITIAL(figures, Hilum);
    HEPATICA_ADD_INITIAL(figures, HilumVessels);
    HEPATICA_ADD_INITIAL(figures, LineOptions);
    HEPATICA_ADD_INITIAL(figures, LiverFrame);
    HEPATICA_ADD_INITIAL(figures, FoundLiver);
    HEPATICA_ADD_INITIAL(figures, SurfaceOptions);
    HEPATICA_ADD_INITIAL(figures, BorderCost);
    HEPATICA_ADD_INITIAL(figures, Lobe);
    HEPATICA_ADD_INITIAL(figures, Lobes);
    HEPATICA_ADD_INITIAL(figures, OrganSurroundings);
    HEPATICA_ADD_INITIAL(figures, Parenchyma);
    HEPATICA_ADD_INITIAL(figures, SoftOrgan);
    HEPATICA_ADD_INITIAL(figures, TissueContrast);
    HEPATICA_ADD_INITIAL(figures, RobustSpread);
    HEPATICA_ADD_INITIAL(figures, LineEvidence);
    HEPATICA_ADD_INITIAL(figures, MeasuredLines);
    HEPATICA_ADD_INITIAL(figures, DetectionOptions);
    HEPATICA_ADD_INITIAL(figures, Detection);
    test::expect_recorded("segmentation", "initial", figures);
}

}  // namespace
}  // namespace hepatica
