// SPDX-License-Identifier: GPL-3.0-or-later
// What runs on over the end of a play has no effect, and what begins later has.
#include "ui/calm_after_play.h"

#include <QWheelEvent>

#include "core/lesson/lesson_draft.h"
#include "core/lesson/lesson_writer.h"
#include "tests/ui/lesson_window_test.h"
#include "ui/paths.h"

namespace hepatica {
namespace {

using testing::wait_for;

TEST(CalmAfterPlay, SwallowsTheRestOfASeries) {
    CalmAfterPlay calm;
    EXPECT_FALSE(calm.swallows(10'000));
    calm.play_ended();
    for (const int at_ms : {10'080, 10'160, 10'600, 11'099, 11'598})
        EXPECT_TRUE(calm.swallows(at_ms)) << at_ms;
    EXPECT_FALSE(calm.swallows(12'098)) << "half a second after the last";
    EXPECT_FALSE(calm.swallows(12'100)) << "it is over";
}

TEST(CalmAfterPlay, LetsPassWhatBeginsAfterwards) {
    CalmAfterPlay calm;
    EXPECT_FALSE(calm.swallows(10'000));
    calm.play_ended();
    EXPECT_FALSE(calm.swallows(10'500)) << "the hand had rested";
    EXPECT_FALSE(calm.swallows(10'510));
    calm.play_ended();
    EXPECT_FALSE(calm.swallows(0)) << "of an event that knows no time";
    EXPECT_TRUE(calm.swallows(10'600)) << "of another play";
    calm.pressed();
    EXPECT_FALSE(calm.swallows(10'610)) << "it belongs to the press";
}

class CalmInTheWindow : public testing::LessonWindowTest {
  protected:
    void turn_wheel(quint64 at_ms) {
        const QPointF place(window_.view().rect().center());
        QWheelEvent wheel(place, window_.view().mapToGlobal(place), {}, QPoint(0, 120),
                          Qt::NoButton, {}, Qt::NoScrollPhase, false);
        wheel.setTimestamp(at_ms);
        QApplication::sendEvent(&window_.view(), &wheel);
    }
    double seen_at() { return window_.view().scene().pixel_of(Vec3(30, 0, 30)).x; }
};

// Notches meant for the tool would enlarge the view.
TEST_F(CalmInTheWindow, what_the_hand_still_turns_as_a_lesson_is_judged_does_not_zoom) {
    Lesson lesson = new_lesson();
    lesson.tools = {LessonTool::sphere};
    lesson.limits = {{Quantity::time_s, -1, false, 1.0}};
    const std::string file = folder_.filePath("lesson.json").toStdString();
    write_lesson(file, lesson);
    window_.lessons().start(file);
    start_clock();
    window_.actions()[ActionId::sphere_tool].trigger();
    ASSERT_EQ(window_.view().mouse().mode(), MouseMode::tool);
    turn_wheel(20'000);
    ASSERT_TRUE(wait_for([&] { return window_.view().mouse().mode() == MouseMode::pull; }));
    const double before = seen_at();
    turn_wheel(20'100);
    EXPECT_EQ(seen_at(), before);
    turn_wheel(20'700);
    EXPECT_NE(seen_at(), before) << "there was time to see that it is judged";
}

}  // namespace
}  // namespace hepatica
