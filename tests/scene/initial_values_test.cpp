// SPDX-License-Identifier: GPL-3.0-or-later
// What objects of this room hold before anyone has written to them.
#include "tests/support/initial_values.h"

#include <gtest/gtest.h>

#include "core/scene/bleeding.h"
#include "core/scene/branch_table.h"
#include "core/scene/cut_line.h"
#include "core/scene/deform_back_end.h"
#include "core/scene/deform_part.h"
#include "core/scene/drug_arrival.h"
#include "core/scene/flow_part.h"
#include "core/scene/frame.h"
#include "core/scene/scene_spec.h"
#include "core/scene/surface_anatomy.h"
#include "core/scene/through_tears.h"
#include "core/scene/tools/tool_choice.h"
#include "core/scene/vertex_places.h"
#include "core/scene/weak_edges.h"
#include "core/scene/world.h"
#include "core/scene/world_checkpoint.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

TEST(SceneInitialFigures, AreThoseRecorded) {
    test::Figures figures;
    HEPATICA_ADD_INITIAL(figures, RestingFlow);
    HEPATICA_ADD_INITIAL(figures, PressedLumen);
    HEPATICA_ADD_INITIAL(figures, PressedStretch);
    HEPATICA_ADD_INITIAL(figures, BranchRow);
    HEPATICA_ADD_INITIAL(figures, BladeSweep);
    HEPATICA_ADD_INITIAL(figures, DeformBackEnd);
    HEPATICA_ADD_INITIAL(figures, DeformSettings);
    HEPATICA_ADD_INITIAL(figures, Hold);
    HEPATICA_ADD_INITIAL(figures, DeformCheckpoint);
    HEPATICA_ADD_INITIAL(figures, Injection);
    HEPATICA_ADD_INITIAL(figures, DrugArrival);
    HEPATICA_ADD_INITIAL(figures, FlowCheckpoint);
    HEPATICA_ADD_INITIAL(figures, GrabView);
    HEPATICA_ADD_INITIAL(figures, ToolView);
    HEPATICA_ADD_INITIAL(figures, ToolView::Part);
    HEPATICA_ADD_INITIAL(figures, DrugView);
    HEPATICA_ADD_INITIAL(figures, TearView);
    HEPATICA_ADD_INITIAL(figures, FrameStatistics);
    HEPATICA_ADD_INITIAL(figures, Frame);
    HEPATICA_ADD_INITIAL(figures, DeformSpec);
    HEPATICA_ADD_INITIAL(figures, FlowSpec);
    HEPATICA_ADD_INITIAL(figures, ContactSpec);
    HEPATICA_ADD_INITIAL(figures, TearSpec);
    HEPATICA_ADD_INITIAL(figures, SceneSpec);
    HEPATICA_ADD_INITIAL(figures, SceneFile);
    HEPATICA_ADD_INITIAL(figures, SurfaceAnatomy);
    HEPATICA_ADD_INITIAL(figures, ThroughTear);
    HEPATICA_ADD_INITIAL(figures, ToolChoice);
    HEPATICA_ADD_INITIAL(figures, VertexPlace);
    HEPATICA_ADD_INITIAL(figures, WeakEdges);
    HEPATICA_ADD_INITIAL(figures, PartCost);
    HEPATICA_ADD_INITIAL(figures, WorldCheckpoint);
    test::expect_recorded("scene", "initial", figures);
}

}  // namespace
}  // namespace hepatica
