// SPDX-License-Identifier: GPL-3.0-or-later
// Making a lesson with the whole window: a place that is clicked on in the view, and a play to try.
#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QTabWidget>
#include <QToolButton>
#include <algorithm>

#include "core/base/error.h"
#include "core/lesson/attempts.h"
#include "core/session/script.h"
#include "tests/session/small_patient.h"
#include "tests/ui/window_test.h"
#include "ui/lesson_dock.h"
#include "ui/lesson_editor/lesson_editor.h"
#include "ui/message_bar.h"
#include "ui/on_screen.h"
#include "ui/paths.h"
#include "ui/patient_place.h"
#include "ui/pointed_place.h"

namespace hepatica {
namespace {

using testing::wait_for;

class LessonEditorWindowTest : public testing::WindowTest {
  protected:
    LessonEditorWindowTest()
        : WindowTest({[](const OpenRequest& request, Job& job) {
                          if (!request.built_in)
                              throw InputError("is not there", "nowhere", "Give another");
                          return play(test::small_patient(), job);
                      },
                      [](const std::filesystem::path&, const PatientCase&) {}}) {
        open_built_in();
    }
    LessonEditor& editor() { return window_.lesson_editor(); }
    void click(const char* name) { editor().findChild<QPushButton*>(name)->click(); }
};

// Places behind the middle of a vessel, before it, and in it.
TEST_F(LessonEditorWindowTest, what_lies_behind_a_vessel_is_known_for_new_marks) {
    paint();
    const SceneView& scene = window_.view().scene();
    const Vec3 middle = point_on_longest_path(test::small_patient()->tree, 0.5);
    const Vec3 forward = scene.axes().forward;
    const Pixel at = scene.pixel_of(middle);
    ASSERT_GE(scene.pick(at).triangle, 0);
    EXPECT_TRUE(is_behind_vessels(scene, scene.point_at_depth(at, middle + 40.0 * forward)));
    EXPECT_FALSE(is_behind_vessels(scene, scene.point_at_depth(at, middle - 40.0 * forward)));
    EXPECT_FALSE(is_behind_vessels(scene, middle)) << "its own wall hides no place";
}

// There is no window manager that would push them back.
TEST_F(LessonEditorWindowTest, lies_wholly_on_the_screen_as_the_first_window_does) {
    const QRect screen = window_.screen()->availableGeometry();
    MainWindow first(settings_, {});
    EXPECT_LE(first.width(), screen.width());
    EXPECT_LE(first.height(), screen.height());
    window_.move(screen.right() - 300, screen.bottom() - 200);
    for (int time = 0; time < 2; ++time) {
        editor().show_editor();
        EXPECT_TRUE(wait_for([&] { return screen.contains(editor().frameGeometry()); }));
        editor().resize(2 * screen.size());
        editor().hide();
    }
}

// The frame that a desktop adds comes after the first show: the window lay lower by its title bar
// from the second time on. Run once more where windows have frames (ui.on_screen_with_frames).
TEST(PlaceOnScreen, IsThatOfTheContentHoweverOftenItIsShown) {
    QWidget window;
    window.resize(200, 100);
    const QPoint wanted = window.screen()->availableGeometry().topLeft() + QPoint(60, 80);
    for (int time = 0; time < 3; ++time) {
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, testing::patience_ms));
        constexpr int title = 40;
        place_on_screen(window, wanted, title);
        EXPECT_TRUE(wait_for([&] { return window.geometry().topLeft() == wanted; })) << time;
        if (QGuiApplication::platformName() == "offscreen") {
            EXPECT_NE(window.frameGeometry(), window.geometry());
        }
        window.hide();
    }
}

TEST_F(LessonEditorWindowTest, a_click_on_a_vessel_sets_the_place) {
    editor().show_editor();
    editor().findChild<QTabWidget*>("lessonPages")->setCurrentIndex(1);
    click("mark0click");
    const Vec3 aim = editor().places().at(0);
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(aim));
    const auto& place = editor().document().lesson().marks[0].place;
    ASSERT_TRUE(place.point_mm);
    // The nearest vertex of the wall decides: within a few millimetres along the vessel.
    EXPECT_LT((*place.point_mm - aim).norm(), 8.0);
    const TreePoint on_tree = nearest_point(test::small_patient()->tree, *place.point_mm);
    EXPECT_LT(on_tree.distance_mm, 0.1) << "on the centreline, to the rounding";
    EXPECT_TRUE(window_.view().mouse().mode() == MouseMode::pull) << "one click, one place";
    const Vec3 set = *place.point_mm;
    const auto labels = editor().findChildren<QLabel*>();
    EXPECT_TRUE(std::ranges::any_of(labels, [&](const QLabel* label) {
        return label->text() == "at " + patient_place(set, 1);
    })) << "as places are written everywhere";
    const Vec3 elsewhere = test::small_patient()->tree.segments.back().points_mm.back();
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(elsewhere));
    editor().place_clicked(elsewhere);
    EXPECT_EQ(*editor().document().lesson().marks[0].place.point_mm, set);
    click("mark0click");
    EXPECT_TRUE(window_.view().mouse().mode() == MouseMode::place);
    click("mark0remove");
    EXPECT_TRUE(window_.view().mouse().mode() == MouseMode::pull) << "nobody waits for it";
}

TEST_F(LessonEditorWindowTest, it_does_not_cover_the_vessels_that_are_to_be_clicked_on) {
    editor().show_editor();
    editor().move(window_.view().mapToGlobal(QPoint()));
    editor().findChild<QTabWidget*>("lessonPages")->setCurrentIndex(1);
    click("mark0click");
    EXPECT_FALSE(editor().isVisible());
    EXPECT_EQ(window_.messages().text(), "Click on a vessel: the place is there");
    ASSERT_EQ(editor().places().size(), 1u) << "they are still to be seen";
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(editor().places().at(0)));
    EXPECT_TRUE(editor().isVisible());
    EXPECT_TRUE(editor().document().lesson().marks[0].place.point_mm);
    EXPECT_EQ(window_.messages().text(), "");
    // Escape, a tool, or the button in the message: it comes back, and nobody waits.
    for (const ActionId other : {ActionId::put_tool_away, ActionId::sphere_tool}) {
        click("mark0click");
        ASSERT_FALSE(editor().isVisible());
        window_.actions()[other].trigger();
        EXPECT_TRUE(editor().isVisible());
        EXPECT_FALSE(window_.view().mouse().mode() == MouseMode::place);
    }
    click("mark0click");
    window_.messages().findChild<QPushButton*>("offer")->click();
    EXPECT_TRUE(editor().isVisible());
    EXPECT_TRUE(window_.view().mouse().mode() == MouseMode::pull);
    click("mark0click");
    ASSERT_TRUE(window_.view().mouse().mode() == MouseMode::place);
    window_.messages().findChild<QToolButton*>("closeMessage")->click();
    EXPECT_TRUE(editor().isVisible());
    EXPECT_TRUE(window_.view().mouse().mode() == MouseMode::pull) << "no mode without a sign of it";
}

TEST_F(LessonEditorWindowTest, escape_closes_an_open_list_and_not_the_editor) {
    editor().show_editor();
    QApplication::setActiveWindow(&editor());
    auto& patients = *editor().findChild<QComboBox*>("lessonPatient");
    patients.showPopup();
    ASSERT_TRUE(patients.view()->isVisible());
    QTest::keyClick(patients.view(), Qt::Key_Escape);
    EXPECT_TRUE(wait_for([&] { return !patients.view()->isVisible(); }));
    EXPECT_TRUE(editor().isVisible());
    QTest::keyClick(&editor(), Qt::Key_Escape);
    EXPECT_TRUE(editor().isHidden()) << "no list is open any more";
}

TEST_F(LessonEditorWindowTest, a_lesson_is_tried_and_leaves_no_attempt) {
    editor().show_editor();
    editor().findChild<QLineEdit*>("lessonName")->setText("Tried");
    editor().findChild<QTabWidget*>("lessonPages")->setCurrentIndex(2);
    editor().findChild<QDoubleSpinBox*>("goal0bound")->setValue(0.0);  // reached after its second
    click("lessonTry");
    ASSERT_TRUE(wait_for([&] { return window_.lessons().playing() && !window_.busy(); }));
    EXPECT_TRUE(editor().isHidden());
    // Another opening that comes to nothing does not end the try.
    window_.open(QString("/nowhere/at/all.hep"));
    ASSERT_TRUE(wait_for([&] { return !window_.busy(); }));
    EXPECT_TRUE(editor().isHidden());
    EXPECT_EQ(window_.lessons().findChild<QLabel*>("lessonTitle")->text(), "<b>Tried</b>");
    // It ends by itself once its clock runs, so that its recording is whole.
    ASSERT_TRUE(wait_for([&] { return window_.frame().statistics.paused; }));
    window_.actions()[ActionId::pause_simulation].trigger();
    ASSERT_TRUE(wait_for([&] { return window_.lessons().recorded(); }));
    wait_for_figures();
    EXPECT_TRUE(window_.lessons().findChild<QLabel*>("lessonEnd")->text().contains("not kept"));
    EXPECT_TRUE(window_.lessons().findChild<QPushButton*>("lessonAttempts")->isHidden());
    window_.lessons().findChild<QPushButton*>("lessonLeave")->click();
    EXPECT_TRUE(editor().isVisible());
    const Attempts attempts = all_attempts(to_path(settings_.recordings_folder()));
    EXPECT_TRUE(attempts.list.empty());
    const std::filesystem::path tried = to_path(settings_.recordings_folder()) / "tried";
    for (const auto& entry : std::filesystem::directory_iterator(tried))
        EXPECT_EQ(entry.path().string().find(".result."), std::string::npos) << entry.path();
    EXPECT_EQ(editor().places().size(), 1u);
}

// As in a play of the lesson; a ball alone does not say what lies beyond it.
TEST_F(LessonEditorWindowTest, the_vessels_of_the_target_are_seen_while_it_is_chosen) {
    const auto lit = [this] {
        return std::ranges::count(window_.view().scene().target(), std::uint8_t{1});
    };
    editor().show_editor();
    EXPECT_EQ(lit(), 0) << "no target";
    editor().findChild<QTabWidget*>("lessonPages")->setCurrentIndex(1);
    click("lessonAddTarget");
    const auto beyond_half = lit();
    EXPECT_GT(beyond_half, 0);
    editor().findChild<QDoubleSpinBox*>("targetshare")->setValue(80.0);
    EXPECT_GT(lit(), 0);
    EXPECT_LT(lit(), beyond_half) << "less lies beyond it";
    click("targetremove");
    EXPECT_EQ(lit(), 0);
    click("lessonUndo");
    EXPECT_GT(lit(), 0);
    editor().hide();
    EXPECT_EQ(lit(), 0) << "nobody edits it";
    editor().show_editor();
    EXPECT_GT(lit(), 0);
    open_built_in();
    EXPECT_TRUE(wait_for([&] { return lit() > 0; })) << "of who is opened";
}

// Nothing of it would be kept, so nothing is lost.
TEST_F(LessonEditorWindowTest, the_window_closes_on_a_lesson_that_is_tried_without_a_question) {
    editor().show_editor();
    click("lessonTry");
    ASSERT_TRUE(wait_for([&] {
        return window_.lessons().playing() && !window_.busy() && window_.frame().statistics.paused;
    }));
    window_.actions()[ActionId::pause_simulation].trigger();
    ASSERT_TRUE(wait_for([&] { return window_.lessons().standing().metrics.time_s > 0.0; }));
    ASSERT_TRUE(window_.lessons().running() != nullptr);
    EXPECT_FALSE(window_.lessons().begun());
    EXPECT_TRUE(window_.close());
    EXPECT_EQ(lesson_ends_asked_, 0);
    EXPECT_TRUE(all_attempts(to_path(settings_.recordings_folder())).list.empty());
}

}  // namespace
}  // namespace hepatica
