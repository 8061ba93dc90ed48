// SPDX-License-Identifier: GPL-3.0-or-later
// What objects of this room hold before anyone has written to them.
#include "tests/support/initial_values.h"

#include <gtest/gtest.h>

#include "core/session/command.h"
#include "core/session/hand_pace.h"
#include "core/session/led_point.h"
#include "core/session/recording.h"
#include "core/session/replay.h"
#include "core/session/script.h"
#include "core/session/session.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

TEST(SessionInitialFigures, AreThoseRecorded) {
    test::Figures figures;
    HEPATICA_ADD_INITIAL(figures, GrabPoint);
    HEPATICA_ADD_INITIAL(figures, GrabVertex);
    HEPATICA_ADD_INITIAL(figures, MoveGrab);
    HEPATICA_ADD_INITIAL(figures, AddTool);
    HEPATICA_ADD_INITIAL(figures, MoveTool);
    HEPATICA_ADD_INITIAL(figures, ShiftGrab);
    HEPATICA_ADD_INITIAL(figures, ShiftTool);
    HEPATICA_ADD_INITIAL(figures, TurnTool);
    HEPATICA_ADD_INITIAL(figures, CloseForceps);
    HEPATICA_ADD_INITIAL(figures, OpenForceps);
    HEPATICA_ADD_INITIAL(figures, UseTools);
    HEPATICA_ADD_INITIAL(figures, CutLine);
    HEPATICA_ADD_INITIAL(figures, UseTear);
    HEPATICA_ADD_INITIAL(figures, UseContact);
    HEPATICA_ADD_INITIAL(figures, Blade);
    HEPATICA_ADD_INITIAL(figures, InjectDrug);
    HEPATICA_ADD_INITIAL(figures, PlayDrug);
    HEPATICA_ADD_INITIAL(figures, SetDrugTime);
    HEPATICA_ADD_INITIAL(figures, SetDrugSpeed);
    HEPATICA_ADD_INITIAL(figures, SetGravity);
    HEPATICA_ADD_INITIAL(figures, SetTether);
    HEPATICA_ADD_INITIAL(figures, SetWall);
    HEPATICA_ADD_INITIAL(figures, SetQuality);
    HEPATICA_ADD_INITIAL(figures, SetAutomaticQuality);
    HEPATICA_ADD_INITIAL(figures, UseSetting);
    HEPATICA_ADD_INITIAL(figures, SetPaused);
    HEPATICA_ADD_INITIAL(figures, HandPace);
    HEPATICA_ADD_INITIAL(figures, LedPoint);
    HEPATICA_ADD_INITIAL(figures, Keyframe);
    HEPATICA_ADD_INITIAL(figures, RecordedStep);
    HEPATICA_ADD_INITIAL(figures, Recording);
    HEPATICA_ADD_INITIAL(figures, ReplayResult);
    HEPATICA_ADD_INITIAL(figures, ScriptPlace);
    HEPATICA_ADD_INITIAL(figures, ScriptAction);
    HEPATICA_ADD_INITIAL(figures, Script);
    HEPATICA_ADD_INITIAL(figures, SessionStep);
    test::expect_recorded("session", "initial", figures);
}

}  // namespace
}  // namespace hepatica
