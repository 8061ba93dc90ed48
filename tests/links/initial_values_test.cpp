// SPDX-License-Identifier: GPL-3.0-or-later
// What objects of this room hold before anyone has written to them.
#include "tests/support/initial_values.h"

#include <gtest/gtest.h>

#include "core/links/line_pieces.h"
#include "core/links/link_model.h"
#include "core/links/piece_forest.h"
#include "core/links/way_to_sure.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

TEST(LinksInitialFigures, AreThoseRecorded) {
    test::Figures figures;
    HEPATICA_ADD_INITIAL(figures, LinePiece);
    HEPATICA_ADD_INITIAL(figures, LinkModel);
    HEPATICA_ADD_INITIAL(figures, ForestNode);
    HEPATICA_ADD_INITIAL(figures, PieceForest);
    HEPATICA_ADD_INITIAL(figures, WayToSure);
    test::expect_recorded("links", "initial", figures);
}

}  // namespace
}  // namespace hepatica
