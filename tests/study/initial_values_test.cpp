// SPDX-License-Identifier: GPL-3.0-or-later
// What objects of this room hold before anyone has written to them.
#include "tests/support/initial_values.h"

#include <gtest/gtest.h>

#include "core/study/contact_study.h"
#include "core/study/contact_tradeoff.h"
#include "core/study/drag_study.h"
#include "core/study/extremes.h"
#include "core/study/frame_meter.h"
#include "core/study/hand_motion.h"
#include "core/study/hand_trial.h"
#include "core/study/haptic_study.h"
#include "core/study/heard_hand.h"
#include "core/study/iteration_study.h"
#include "core/study/job_watch.h"
#include "core/study/pull_trial.h"
#include "core/study/reference_beam.h"
#include "core/study/region_study.h"
#include "core/study/step_study.h"
#include "core/study/tear_study.h"
#include "core/study/timing.h"
#include "core/study/touching_blocks.h"
#include "core/study/tradeoff.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

TEST(StudyInitialFigures, AreThoseRecorded) {
    test::Figures figures;
    HEPATICA_ADD_INITIAL(figures, ContactStudyOptions);
    HEPATICA_ADD_INITIAL(figures, ContactRow);
    HEPATICA_ADD_INITIAL(figures, ContactPoint);
    HEPATICA_ADD_INITIAL(figures, ContactTradeoffOptions);
    HEPATICA_ADD_INITIAL(figures, TouchingBlocks);
    HEPATICA_ADD_INITIAL(figures, DragQuantiles);
    HEPATICA_ADD_INITIAL(figures, DragSummary);
    HEPATICA_ADD_INITIAL(figures, ExtremeRow);
    HEPATICA_ADD_INITIAL(figures, ExtremeCase);
    HEPATICA_ADD_INITIAL(figures, Campaign);
    HEPATICA_ADD_INITIAL(figures, FrameMeter);
    HEPATICA_ADD_INITIAL(figures, HandMotion);
    HEPATICA_ADD_INITIAL(figures, HandFrame);
    HEPATICA_ADD_INITIAL(figures, HandPlay);
    HEPATICA_ADD_INITIAL(figures, HapticStudyOptions);
    HEPATICA_ADD_INITIAL(figures, HapticStudy);
    HEPATICA_ADD_INITIAL(figures, HeardHand);
    HEPATICA_ADD_INITIAL(figures, StudySystem);
    HEPATICA_ADD_INITIAL(figures, IterationRow);
    HEPATICA_ADD_INITIAL(figures, IterationStudyOptions);
    HEPATICA_ADD_INITIAL(figures, WatchedTime);
    HEPATICA_ADD_INITIAL(figures, WatchedStage);
    HEPATICA_ADD_INITIAL(figures, MotionDifference);
    HEPATICA_ADD_INITIAL(figures, Discretisation);
    HEPATICA_ADD_INITIAL(figures, BeamSpec);
    HEPATICA_ADD_INITIAL(figures, RegionRow);
    HEPATICA_ADD_INITIAL(figures, RegionStudyOptions);
    HEPATICA_ADD_INITIAL(figures, StepRow);
    HEPATICA_ADD_INITIAL(figures, StepStudyOptions);
    HEPATICA_ADD_INITIAL(figures, TearStudyOptions);
    HEPATICA_ADD_INITIAL(figures, BreakingRow);
    HEPATICA_ADD_INITIAL(figures, TearRow);
    HEPATICA_ADD_INITIAL(figures, TearRow::Sample);
    HEPATICA_ADD_INITIAL(figures, FrameTime);
    HEPATICA_ADD_INITIAL(figures, TradeoffPoint);
    HEPATICA_ADD_INITIAL(figures, Tradeoff);
    HEPATICA_ADD_INITIAL(figures, TradeoffOptions);
    test::expect_recorded("study", "initial", figures);
}

}  // namespace
}  // namespace hepatica
