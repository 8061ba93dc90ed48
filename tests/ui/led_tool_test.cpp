// SPDX-License-Identifier: GPL-3.0-or-later
// In a step that asks for the distance of the tip no click brings the tool to the mark.
#include <QPushButton>
#include <QStatusBar>

#include "tests/ui/lesson_window_test.h"
#include "ui/vtk_widget.h"

namespace hepatica {
namespace {

using testing::wait_for;

class LedTool : public testing::LessonWindowTest {
  protected:
    bool clicks_bring_in(const char* goal) {
        window_.lessons().start(lesson_file(goal));
        EXPECT_TRUE(wait_for([&] { return window_.lessons().playing() && !window_.busy(); }));
        return window_.view().mouse().hand().may_bring();
    }
};

TEST_F(LedTool, is_brought_by_clicks_but_where_the_step_asks_for_its_distance) {
    const auto said = [this] { return window_.statusBar()->currentMessage(); };
    EXPECT_TRUE(clicks_bring_in(R"({"what": "touch_mm", "mark": "the mark", "at_most": 2})"));
    EXPECT_FALSE(said().contains("lead the tool"));
    EXPECT_FALSE(clicks_bring_in(R"({"what": "distance_mm", "mark": "the mark", "at_most": 2})"));
    EXPECT_TRUE(said().contains("lead the tool")) << said().toStdString();
    window_.lessons().findChild<QPushButton*>("lessonLeave")->click();
    ASSERT_TRUE(wait_for([&] { return !window_.lessons().playing(); }));
    EXPECT_TRUE(window_.view().mouse().hand().may_bring());
}

}  // namespace
}  // namespace hepatica
