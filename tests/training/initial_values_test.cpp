// SPDX-License-Identifier: GPL-3.0-or-later
// What objects of this room hold before anyone has written to them.
#include "tests/support/initial_values.h"

#include <gtest/gtest.h>

#include "core/training/grown_forest.h"
#include "core/training/link_training.h"
#include "core/training/taught_pieces.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

TEST(TrainingInitialFigures, AreThoseRecorded) {
    test::Figures figures;
    HEPATICA_ADD_INITIAL(figures, ForestOptions);
    HEPATICA_ADD_INITIAL(figures, TrainingOptions);
    HEPATICA_ADD_INITIAL(figures, TaughtPiece);
    test::expect_recorded("training", "initial", figures);
}

}  // namespace
}  // namespace hepatica
