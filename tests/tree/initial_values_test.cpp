// SPDX-License-Identifier: GPL-3.0-or-later
// What objects of this room hold before anyone has written to them.
#include "tests/support/initial_values.h"

#include <gtest/gtest.h>

#include "core/tree/editing/drawn_vessel.h"
#include "core/tree/editing/system_seed.h"
#include "core/tree/editing/tree_edit.h"
#include "core/tree/extraction/bridged_points.h"
#include "core/tree/extraction/centreline.h"
#include "core/tree/extraction/centreline_locator.h"
#include "core/tree/extraction/component_pruning.h"
#include "core/tree/extraction/cut_gap.h"
#include "core/tree/extraction/gap_bridging.h"
#include "core/tree/extraction/gap_paths.h"
#include "core/tree/extraction/line_graph.h"
#include "core/tree/extraction/lumen_radius.h"
#include "core/tree/extraction/vessel_graph.h"
#include "core/tree/files/tree_io.h"
#include "core/tree/files/vtk_file.h"
#include "core/tree/files/vtk_payload.h"
#include "core/tree/lumen_calibre.h"
#include "core/tree/station.h"
#include "core/tree/system_summary.h"
#include "core/tree/systems/anatomical_anchors.h"
#include "core/tree/systems/doubtful_roots.h"
#include "core/tree/systems/labelled_graph.h"
#include "core/tree/systems/loop_opening.h"
#include "core/tree/systems/portal_trunk.h"
#include "core/tree/systems/potts_labelling.h"
#include "core/tree/systems/seeded_spread.h"
#include "core/tree/systems/system_evidence.h"
#include "core/tree/systems/tell_systems_apart.h"
#include "core/tree/systems/vessel_pieces.h"
#include "core/tree/territories/couinaud_branches.h"
#include "core/tree/territories/couinaud_frame.h"
#include "core/tree/territories/couinaud_segments.h"
#include "core/tree/territories/feeders.h"
#include "core/tree/tree_extraction.h"
#include "core/tree/vessel_tree.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

TEST(TreeInitialFigures, AreThoseRecorded) {
    test::Figures figures;
    HEPATICA_ADD_INITIAL(figures, DrawnVessel);
    HEPATICA_ADD_INITIAL(figures, SystemSeed);
    HEPATICA_ADD_INITIAL(figures, SeededGraph);
    HEPATICA_ADD_INITIAL(figures, TreeEdit);
    HEPATICA_ADD_INITIAL(figures, BridgedPoints);
    HEPATICA_ADD_INITIAL(figures, Centreline);
    HEPATICA_ADD_INITIAL(figures, CentrelineLocator::Nearest);
    HEPATICA_ADD_INITIAL(figures, RemovedPieces);
    HEPATICA_ADD_INITIAL(figures, CutStretch);
    HEPATICA_ADD_INITIAL(figures, BridgeOptions);
    HEPATICA_ADD_INITIAL(figures, Bridge);
    HEPATICA_ADD_INITIAL(figures, GapPath);
    HEPATICA_ADD_INITIAL(figures, GapSearch);
    HEPATICA_ADD_INITIAL(figures, LineEdge);
    HEPATICA_ADD_INITIAL(figures, LineGraph);
    HEPATICA_ADD_INITIAL(figures, CrossSection);
    HEPATICA_ADD_INITIAL(figures, VesselLink);
    HEPATICA_ADD_INITIAL(figures, VesselGraph);
    HEPATICA_ADD_INITIAL(figures, RootWish);
    HEPATICA_ADD_INITIAL(figures, TreeFileFacts);
    HEPATICA_ADD_INITIAL(figures, VtkCells);
    HEPATICA_ADD_INITIAL(figures, VtkEncoding);
    HEPATICA_ADD_INITIAL(figures, LumenCalibre);
    HEPATICA_ADD_INITIAL(figures, Station);
    HEPATICA_ADD_INITIAL(figures, NearestStation);
    HEPATICA_ADD_INITIAL(figures, SystemRoot);
    HEPATICA_ADD_INITIAL(figures, SystemSummary);
    HEPATICA_ADD_INITIAL(figures, AnatomicalAnchors);
    HEPATICA_ADD_INITIAL(figures, DoubtfulRoot);
    HEPATICA_ADD_INITIAL(figures, PieceSystem);
    HEPATICA_ADD_INITIAL(figures, OpenedLoops);
    HEPATICA_ADD_INITIAL(figures, ShortTrunk);
    HEPATICA_ADD_INITIAL(figures, Tie);
    HEPATICA_ADD_INITIAL(figures, PottsProblem);
    HEPATICA_ADD_INITIAL(figures, SeededVessel);
    HEPATICA_ADD_INITIAL(figures, Trunks);
    HEPATICA_ADD_INITIAL(figures, SystemSearch);
    HEPATICA_ADD_INITIAL(figures, SystemsFound);
    HEPATICA_ADD_INITIAL(figures, VesselPiece);
    HEPATICA_ADD_INITIAL(figures, ForkArm);
    HEPATICA_ADD_INITIAL(figures, PieceGraph);
    HEPATICA_ADD_INITIAL(figures, BranchLabel);
    HEPATICA_ADD_INITIAL(figures, CouinaudFrame);
    HEPATICA_ADD_INITIAL(figures, LabelledPortalVein);
    HEPATICA_ADD_INITIAL(figures, CouinaudSegments);
    HEPATICA_ADD_INITIAL(figures, Feeder);
    HEPATICA_ADD_INITIAL(figures, TreeOptions);
    HEPATICA_ADD_INITIAL(figures, TreeExtraction);
    HEPATICA_ADD_INITIAL(figures, VesselNode);
    HEPATICA_ADD_INITIAL(figures, VesselSegment);
    HEPATICA_ADD_INITIAL(figures, VesselTree);
    test::expect_recorded("tree", "initial", figures);
}

TEST(TreeInitialFigures, AreThoseRecordedOfOthers) {
    test::Figures figures;
    HEPATICA_ADD_INITIAL(figures, TreePoint);
    test::expect_recorded("tree", "initial_others", figures);
}

}  // namespace
}  // namespace hepatica
