// SPDX-License-Identifier: GPL-3.0-or-later
// Another recording beside the one that is looked back on: its view, its marks and its name.
#include <QDockWidget>
#include <QLabel>
#include <algorithm>
#include <cmath>

#include "core/lesson/attempts.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_writer.h"
#include "tests/ui/review_window_test.h"
#include "ui/message_bar.h"
#include "ui/second_view.h"

namespace hepatica {
namespace {

using testing::ReviewWindowTest;
using testing::wait_for;

// An attempt from before the lesson was changed: its frames are of the surface alone, and the marks
// are vertices of the body.
TEST_F(ReviewWindowTest, what_is_beside_it_has_no_marks_of_another_scene) {
    Lesson lesson;
    lesson.name = "Pull";
    lesson.scene = played().recording.scene;
    lesson.tools = {LessonTool::pull};
    lesson.marks = {{"the mark", {std::nullopt, 0.5}}};
    lesson.steps = {{"Pull", "", {{Quantity::moved_mm, 0, true, 1000.0}}, 0.0, {}}};
    const std::filesystem::path place = to_path(folder_.filePath("lesson.json"));
    write_lesson(place, lesson);
    SceneSpec without_motion = default_scene();
    without_motion.deform.reset();
    const auto session = test::new_session(without_motion);
    const auto recording = test::keep_recording(*session);
    test::play(*session, 20);
    const std::filesystem::path other = to_path(folder_.filePath("other.hrec"));
    write_recording(other, *recording);
    for (const std::filesystem::path& of_one : {file_, other}) {
        Attempt attempt;
        attempt.recording = of_one;
        attempt.lesson = lesson.name;
        attempt.ended_at = "2026";
        write_attempt(attempt);
    }
    open_built_in();
    dock().open(file_, place.string());
    ASSERT_TRUE(wait_for([this] { return dock().complete(); }));
    EXPECT_EQ(dock().marks_in(window_.frame()).size(), 1u);
    dock().compare(other);
    ASSERT_TRUE(wait_for([this] { return dock().complete() && window_.second_view().shown(); }));
    EXPECT_TRUE(window_.second_view().view().scene().marks().empty());
}

// Of a lesson of its own: else nobody sees where the tip was to go.
TEST_F(ReviewWindowTest, what_is_beside_it_has_the_marks_of_its_own_lesson) {
    const Lesson lesson = find_lesson("gentle_pull");
    ASSERT_FALSE(lesson.marks.empty());
    const auto session = test::new_session(lesson.scene);
    const auto recording = test::keep_recording(*session);
    test::play(*session, 20);
    const auto other = to_path(folder_.filePath("gentle_pull-20261126-034000-123.hrec"));
    write_recording(other, *recording);
    open_built_in();
    look_back();
    ASSERT_TRUE(dock().marks_in(window_.frame()).empty()) << "a free play";
    dock().compare(other);
    ASSERT_TRUE(wait_for([this] { return dock().complete() && window_.second_view().shown(); }));
    EXPECT_EQ(window_.second_view().view().scene().marks().size(), lesson.marks.size());
}

// The bar of a job covers as much of the one as of the other, and their words keep clear of it.
TEST_F(ReviewWindowTest, both_views_are_covered_alike_by_the_progress_of_a_job) {
    open_built_in();
    look_back();
    auto* strip = window_.findChild<QWidget*>("progressStrip");
    strip->show();
    dock().compare(file_);
    ASSERT_TRUE(wait_for([this] { return dock().complete() && window_.second_view().shown(); }));
    ASSERT_TRUE(wait_for([&] {
        return std::abs(window_.view().width() - window_.second_view().view().width()) < 20;
    }));
    for (VtkWidget* view : {&window_.view(), &window_.second_view().view()}) {
        const QRect bar(strip->mapTo(&window_, QPoint()), strip->size());
        const QRect picture(view->mapTo(&window_, QPoint()), view->size());
        EXPECT_LE(bar.left(), picture.left());
        EXPECT_GE(bar.right(), picture.right());
        EXPECT_EQ(bar.bottom(), picture.bottom());
        EXPECT_FALSE(view->scene().set_covered(0, strip->height())) << "it knew already";
    }
    strip->hide();
    EXPECT_FALSE(window_.second_view().view().scene().set_covered(0, 0));
}

// A second play of the same patient, half as long, in which nothing happens.
TEST_F(ReviewWindowTest, another_recording_is_shown_beside_it_and_looks_the_same_way) {
    open_built_in();
    look_back();
    const std::filesystem::path other = to_path(folder_.filePath("other.hrec"));
    const auto session = test::new_session();
    const auto recording = test::keep_recording(*session);
    test::play(*session, 50);
    write_recording(other, *recording);
    dock().compare(other);
    ASSERT_TRUE(wait_for([this] { return dock().complete() && window_.second_view().shown(); }));
    EXPECT_NEAR(line().end_s(), steps / 60.0, 2e-3) << "the longer one's";
    line().set_at(30.2 / 60);
    EXPECT_TRUE(shows_step(29));
    VtkWidget& beside = window_.second_view().view();
    ASSERT_TRUE(wait_for([&] {
        beside.drawn();
        return !beside.scene().look_as(window_.view().scene());
    }));
    window_.actions()[ActionId::view_superior].trigger();
    EXPECT_TRUE(wait_for(
        [&] { return beside.scene().axes().forward == window_.view().scene().axes().forward; }));
    click("reviewCompare");
    EXPECT_FALSE(dock().comparing());
    EXPECT_FALSE(window_.second_view().shown());
    EXPECT_TRUE(dock().reviewing());
    // One of another patient is refused, and what is shown stays.
    Recording foreign = played().recording;
    foreign.patient_hash ^= 1;
    write_recording(other, foreign);
    dock().compare(other);
    EXPECT_TRUE(wait_for([this] { return !dock().comparing(); }));
    EXPECT_TRUE(window_.messages().text().contains("another patient"));
    EXPECT_TRUE(dock().reviewing());
}

// Which is little beside the panels on a small screen; a review needs none of them.
TEST_F(ReviewWindowTest, two_recordings_have_the_room_of_the_panels) {
    open_built_in();
    look_back();
    const auto at_the_right = [this] {
        std::vector<QString> shown;
        for (const auto* panel : window_.findChildren<QDockWidget*>())
            if (window_.dockWidgetArea(const_cast<QDockWidget*>(panel)) ==
                    Qt::RightDockWidgetArea &&
                !panel->isHidden())
                shown.push_back(panel->objectName());
        return shown;
    };
    auto& tool = *window_.findChild<QDockWidget*>("Tool");
    window_.findChild<QDockWidget*>("Corrections")->close();
    tool.raise();
    ASSERT_TRUE(wait_for([&] { return !tool.visibleRegion().isEmpty(); }));
    const std::vector<QString> before = at_the_right();
    ASSERT_GT(before.size(), 1u);
    for (int time = 0; time < 2; ++time) {
        dock().compare(file_);
        ASSERT_TRUE(
            wait_for([this] { return dock().complete() && window_.second_view().shown(); }));
        EXPECT_TRUE(at_the_right().empty());
        time == 0 ? click("reviewCompare") : click("reviewLeave");
        EXPECT_EQ(at_the_right(), before);
        EXPECT_TRUE(wait_for([&] { return !tool.visibleRegion().isEmpty(); }));
    }
}

// The first view draws what it took over after the second was turned on: its picture takes nothing
// back.
TEST_F(ReviewWindowTest, what_is_beside_it_is_turned_as_freely) {
    open_built_in();
    look_back();
    dock().compare(file_);
    ASSERT_TRUE(wait_for([this] { return dock().complete() && window_.second_view().shown(); }));
    SecondView& second = window_.second_view();
    SceneView& first_scene = window_.view().scene();
    SceneView& beside = second.view().scene();
    ASSERT_TRUE(wait_for([&] {
        window_.view().drawn();
        second.follow_first();
        second.view().drawn();
        const bool side_by_side = std::abs(window_.view().width() - second.view().width()) < 20;
        return side_by_side && !beside.look_as(first_scene);
    }));
    beside.turn_by(20.0, 0.0);
    const Vec3 turned = beside.axes().forward;
    second.follow_first();
    EXPECT_EQ(beside.axes().forward, turned);
    second.view().draw_again();
    EXPECT_TRUE(wait_for([&] { return first_scene.axes().forward == turned; }));
    EXPECT_EQ(beside.axes().forward, turned);
}

// The look and the mouse that were chosen before and are chosen meanwhile.
TEST_F(ReviewWindowTest, what_is_beside_it_has_the_look_and_the_mouse_of_the_first_view) {
    open_built_in();
    look_back();
    window_.findChild<QAction*>("mouse_slicer")->trigger();
    dock().compare(file_);
    ASSERT_TRUE(wait_for([this] { return dock().complete() && window_.second_view().shown(); }));
    VtkWidget& beside = window_.second_view().view();
    EXPECT_STREQ(beside.mouse().scheme().name, "slicer");
    const QImage dark = beside.drawn();
    window_.actions()[ActionId::theme_light].trigger();
    window_.findChild<QAction*>("mouse_construction")->trigger();
    EXPECT_STREQ(beside.mouse().scheme().name, "construction");
    const QColor was = dark.pixelColor(3, dark.height() / 2);
    const QImage light = beside.drawn();
    EXPECT_GT(light.pixelColor(3, light.height() / 2).lightness(), was.lightness() + 50);
    window_.actions()[ActionId::theme_dark].trigger();
}

// Neither says when it was played.
TEST_F(ReviewWindowTest, each_of_two_recordings_stands_under_its_own_name) {
    open_built_in();
    look_back();
    const std::filesystem::path other = to_path(folder_.filePath("other.hrec"));
    write_recording(other, played().recording);
    dock().compare(other);
    ASSERT_TRUE(wait_for([this] { return dock().complete() && window_.second_view().shown(); }));
    const QString title = dock().findChild<QLabel*>("reviewTitle")->text();
    const QStringList names = title.split(", and beside it ");
    ASSERT_EQ(names.size(), 2) << title.toStdString();
    EXPECT_TRUE(names[0].startsWith("1: Free play, ")) << title.toStdString();
    EXPECT_TRUE(names[1].startsWith("2: ") && names[1].contains("other, ")) << title.toStdString();
    EXPECT_FALSE(window_.view().scene().set_caption(names[0].toStdString())) << "it has that one";
    EXPECT_FALSE(window_.second_view().view().scene().set_caption(names[1].toStdString()));
}

}  // namespace
}  // namespace hepatica
