// SPDX-License-Identifier: GPL-3.0-or-later
// What objects of this room hold before anyone has written to them.
#include "tests/support/initial_values.h"

#include <gtest/gtest.h>

#include "core/accuracy/accuracy.h"
#include "core/accuracy/centreline_samples.h"
#include "core/accuracy/false_joins.h"
#include "core/accuracy/found_length.h"
#include "core/accuracy/judged_region.h"
#include "core/accuracy/organ_score.h"
#include "core/accuracy/system_scores.h"
#include "core/accuracy/system_truth.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

TEST(AccuracyInitialFigures, AreThoseRecorded) {
    test::Figures figures;
    HEPATICA_ADD_INITIAL(figures, AccuracyOptions);
    HEPATICA_ADD_INITIAL(figures, Accuracy);
    HEPATICA_ADD_INITIAL(figures, CentrelineSample);
    HEPATICA_ADD_INITIAL(figures, CentrelineStep);
    HEPATICA_ADD_INITIAL(figures, CentrelineSamples);
    HEPATICA_ADD_INITIAL(figures, JoinOptions);
    HEPATICA_ADD_INITIAL(figures, FoundLength);
    HEPATICA_ADD_INITIAL(figures, CavaNeighbourhood);
    HEPATICA_ADD_INITIAL(figures, OrganScore);
    HEPATICA_ADD_INITIAL(figures, SystemScoreOptions);
    HEPATICA_ADD_INITIAL(figures, RadiusClass);
    HEPATICA_ADD_INITIAL(figures, SystemScore);
    HEPATICA_ADD_INITIAL(figures, SystemScores);
    HEPATICA_ADD_INITIAL(figures, SystemTruth);
    test::expect_recorded("accuracy", "initial", figures);
}

}  // namespace
}  // namespace hepatica
