// SPDX-License-Identifier: GPL-3.0-or-later
// What objects of this room hold before anyone has written to them.
#include "tests/support/initial_values.h"

#include <gtest/gtest.h>

#include "core/lesson/attempts.h"
#include "core/lesson/course_standing.h"
#include "core/lesson/dose_account.h"
#include "core/lesson/draft_file.h"
#include "core/lesson/lesson.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_run.h"
#include "core/lesson/metrics.h"
#include "core/lesson/play_events.h"
#include "core/lesson/play_notes.h"
#include "core/lesson/predicate.h"
#include "core/lesson/review.h"
#include "core/lesson/review_tape.h"
#include "core/lesson/scene_parts.h"
#include "core/lesson/score.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

TEST(LessonInitialFigures, AreThoseRecorded) {
    test::Figures figures;
    HEPATICA_ADD_INITIAL(figures, Attempt);
    HEPATICA_ADD_INITIAL(figures, Attempts);
    HEPATICA_ADD_INITIAL(figures, Band);
    HEPATICA_ADD_INITIAL(figures, CourseLine);
    HEPATICA_ADD_INITIAL(figures, Dose);
    HEPATICA_ADD_INITIAL(figures, LessonDraft);
    HEPATICA_ADD_INITIAL(figures, LessonMark);
    HEPATICA_ADD_INITIAL(figures, LessonStep);
    HEPATICA_ADD_INITIAL(figures, Lesson);
    HEPATICA_ADD_INITIAL(figures, CourseEntry);
    HEPATICA_ADD_INITIAL(figures, Course);
    HEPATICA_ADD_INITIAL(figures, BuiltInLesson);
    HEPATICA_ADD_INITIAL(figures, BoundStanding);
    HEPATICA_ADD_INITIAL(figures, StepStanding);
    HEPATICA_ADD_INITIAL(figures, LessonStanding);
    HEPATICA_ADD_INITIAL(figures, LessonSample);
    HEPATICA_ADD_INITIAL(figures, LessonMetrics);
    HEPATICA_ADD_INITIAL(figures, MarkMoment);
    HEPATICA_ADD_INITIAL(figures, LessonMoment);
    HEPATICA_ADD_INITIAL(figures, PlaceTie);
    HEPATICA_ADD_INITIAL(figures, PlayEvent);
    HEPATICA_ADD_INITIAL(figures, PlayEvents);
    HEPATICA_ADD_INITIAL(figures, PlayNote);
    HEPATICA_ADD_INITIAL(figures, QuantityWords);
    HEPATICA_ADD_INITIAL(figures, Predicate);
    HEPATICA_ADD_INITIAL(figures, Review);
    HEPATICA_ADD_INITIAL(figures, ReviewTape);
    HEPATICA_ADD_INITIAL(figures, SceneParts);
    HEPATICA_ADD_INITIAL(figures, Score);
    test::expect_recorded("lesson", "initial", figures);
}

}  // namespace
}  // namespace hepatica
