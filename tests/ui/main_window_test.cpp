// SPDX-License-Identifier: GPL-3.0-or-later
// The window driven as a person does: mouse, keys, drops. Runs under Xvfb.
#include "ui/main_window.h"

#include <QAbstractButton>
#include <QDockWidget>
#include <QDropEvent>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QScreen>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTimer>
#include <filesystem>
#include <stdexcept>

#include "core/base/error.h"
#include "tests/ui/fake_window_test.h"
#include "ui/message_bar.h"
#include "ui/paths.h"

namespace hepatica {
namespace {

class Window : public testing::FakeWindowTest {};

TEST_F(Window, the_grabbed_vertex_follows_the_mouse) {
    open_built_in();
    VtkWidget& view = window_.view();
    const Vec3 trunk(0, 0, half_way_up_the_trunk_mm);
    const QPoint start = on_widget(trunk);
    const SurfacePick held = view.scene().pick(pixel_at(start, view.devicePixelRatioF()));
    ASSERT_GE(held.triangle, 0);

    QTest::mousePress(&view, Qt::LeftButton, {}, start);
    ASSERT_EQ(commands_of_type<GrabPoint>().size(), 1u);
    EXPECT_NEAR((commands_of_type<GrabPoint>()[0].point_mm - held.position_mm).norm(), 0, 0.3);
    for (int i = 1; i <= 6; ++i) {
        const QPoint now = start + QPoint(15 * i, -4 * i);
        QTest::mouseMove(&view, now);
        paint();
        const Frame& frame = simulation_->frame();
        const float* vertex =
            &frame.positions_mm[3 * static_cast<std::size_t>(held.nearest_vertex)];
        const QPoint seen = on_widget(Vec3(vertex[0], vertex[1], vertex[2]));
        // The vertex is next to the held point, not at it.
        EXPECT_LT((seen - now).manhattanLength(), 16) << "move " << i;
    }
    QTest::mouseRelease(&view, Qt::LeftButton, {}, start + QPoint(90, -24));
    EXPECT_EQ(commands_of_type<ReleaseGrab>().size(), 1u);
    EXPECT_FALSE(view.mouse().pulling());
}

// A mark may lie behind another vessel: it is what the lesson asks to be pulled.
TEST_F(Window, a_drag_on_a_mark_pulls_at_the_mark) {
    open_built_in();
    VtkWidget& view = window_.view();
    SceneView& scene = view.scene();
    const QPoint start = on_trunk();
    const Pixel pixel = pixel_at(start, view.devicePixelRatioF());
    const SurfacePick wall = scene.pick(pixel);
    ASSERT_GE(wall.triangle, 0);
    const auto held_with_mark = [&](double behind_mm) {
        const Vec3 mark =
            scene.point_at_depth(pixel, wall.position_mm + behind_mm * scene.axes().forward);
        scene.set_marks({{mark, ""}});
        QTest::mousePress(&view, Qt::LeftButton, {}, start);
        QTest::mouseRelease(&view, Qt::LeftButton, {}, start);
        return (commands_of_type<GrabPoint>().back().point_mm - wall.position_mm)
            .dot(scene.axes().forward);
    };
    EXPECT_NEAR(held_with_mark(25.0), 25.0, 0.5);
    EXPECT_NEAR(held_with_mark(3.0), 0.0, 0.5) << "the wall in front of it is its own vessel's";
}

TEST_F(Window, offers_to_open_unsaved_work_only_where_there_is_some) {
    QAction& entry = window_.actions()[ActionId::open_unsaved];
    const auto open_menu = [&] {
        for (QObject* shows : entry.associatedObjects())
            if (auto* menu = qobject_cast<QMenu*>(shows)) emit menu->aboutToShow();
    };
    EXPECT_FALSE(entry.isEnabled()) << "before the menu was ever opened";
    open_menu();
    EXPECT_FALSE(entry.isEnabled());
    EXPECT_TRUE(entry.toolTip().contains("No earlier run left unsaved work"))
        << entry.toolTip().toStdString();
    const auto copy = to_path(settings_.recovery_folder()) / "left" / "1" / "Anna.hep";
    std::filesystem::create_directories(copy);
    QFile header(to_text(copy / "case.json"));
    ASSERT_TRUE(header.open(QIODevice::WriteOnly));
    header.close();
    open_menu();
    EXPECT_TRUE(entry.isEnabled());
    EXPECT_FALSE(entry.toolTip().contains("No earlier run"));
    std::filesystem::remove_all(copy);
    open_menu();
    EXPECT_FALSE(entry.isEnabled());
}

TEST_F(Window, enter_presses_the_button_of_the_start_page_that_has_the_focus) {
    auto& lesson = *window_.findChild<QPushButton*>("welcomeLessons");
    lesson.setFocus();
    ASSERT_TRUE(lesson.hasFocus());
    const QSignalSpy pressed(&lesson, &QPushButton::clicked);
    QTest::keyClick(&lesson, Qt::Key_Return);
    EXPECT_EQ(pressed.count(), 1);
}

// Default buttons are lit: two of them would hide which one Enter presses.
TEST_F(Window, of_the_buttons_of_the_start_page_the_one_with_the_focus_alone_is_lit) {
    const auto lit = [this] {
        QList<QPushButton*> found;
        for (QPushButton* button :
             window_.findChild<QWidget*>("welcome")->findChildren<QPushButton*>())
            if (button->isDefault() || button->hasFocus()) found << button;
        return found;
    };
    window_.view().setFocus();
    EXPECT_TRUE(lit().isEmpty()) << "Enter presses none";
    for (const char* name : {"welcomeFirst", "welcomeLessons"}) {
        auto* button = window_.findChild<QPushButton*>(name);
        button->setFocus();
        EXPECT_EQ(lit(), QList<QPushButton*>{button}) << name;
        EXPECT_TRUE(button->isDefault()) << name;
    }
}

TEST_F(Window, tab_goes_past_the_empty_view_behind_the_start_page) {
    auto* first = window_.findChild<QPushButton*>("welcomeFirst");
    for (const Qt::Key key : {Qt::Key_Backtab, Qt::Key_Tab}) {
        first->setFocus();
        int controls = 0;
        do {
            QWidget* before = QApplication::focusWidget();
            QTest::keyClick(before, key);
            ASSERT_NE(QApplication::focusWidget(), before);
            EXPECT_NE(QApplication::focusWidget(), &window_.view());
            ASSERT_LT(++controls, 200);
        } while (!first->hasFocus());
        EXPECT_GT(controls, 4);
    }
    open_built_in();
    EXPECT_TRUE(window_.view().focusPolicy() & Qt::TabFocus);
}

TEST_F(Window, no_tool_is_offered_while_there_is_no_patient) {
    const auto enabled = [this](ActionId id) { return window_.actions()[id].isEnabled(); };
    for (const ActionId id : body_actions) EXPECT_FALSE(enabled(id));
    EXPECT_FALSE(enabled(ActionId::inject_mode));
    open_built_in();
    for (const ActionId id : body_actions) EXPECT_TRUE(enabled(id));
    EXPECT_TRUE(enabled(ActionId::inject_mode));
}

TEST_F(Window, enter_in_the_view_speaks_of_no_vessels_where_there_are_none) {
    window_.view().setFocus();
    window_.statusBar()->clearMessage();
    QTest::keyClick(&window_.view(), Qt::Key_Return);
    EXPECT_EQ(window_.statusBar()->currentMessage(), "");
}

TEST_F(Window, a_click_in_inject_mode_injects_where_it_points) {
    open_built_in();
    window_.actions()[ActionId::inject_mode].trigger();
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_trunk());
    ASSERT_EQ(commands_of_type<InjectDrug>().size(), 1u);
    const InjectDrug injection = commands_of_type<InjectDrug>()[0];
    EXPECT_NEAR(injection.point_mm.z(), half_way_up_the_trunk_mm, 2.0);
    EXPECT_GT(injection.mass_flow_g_s, 0.0);
    EXPECT_TRUE(commands_of_type<GrabPoint>().empty());
    paint();
    const double before = simulation_->frame().drug.time_s;
    paint();
    EXPECT_GT(simulation_->frame().drug.time_s, before);
}

TEST_F(Window, control_click_and_double_click_inject_in_pull_mode_too) {
    open_built_in();
    QTest::mouseClick(&window_.view(), Qt::LeftButton, Qt::ControlModifier, on_trunk());
    EXPECT_EQ(commands_of_type<InjectDrug>().size(), 1u);
    // Qt's own double click lacks the click before it.
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_trunk());
    QTest::mouseDClick(&window_.view(), Qt::LeftButton, {}, on_trunk());
    EXPECT_EQ(commands_of_type<InjectDrug>().size(), 2u);
}

TEST_F(Window, a_drag_beside_the_vessels_orbits_and_sends_nothing) {
    open_built_in();
    VtkWidget& view = window_.view();
    const Vec3 tip(30, 0, 40);
    const QPoint before = on_widget(tip);
    QTest::mousePress(&view, Qt::LeftButton, {}, QPoint(20, 20));
    QTest::mouseMove(&view, QPoint(120, 40));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, QPoint(120, 40));
    EXPECT_GT((on_widget(tip) - before).manhattanLength(), 10);
    EXPECT_TRUE(simulation_->commands().empty());
}

TEST_F(Window, cancel_ends_a_job_and_leaves_the_window_as_it_was) {
    open_built_in();
    window_.open(folder_.filePath("endless"));
    ASSERT_TRUE(window_.busy());
    QPushButton* cancel = nullptr;
    EXPECT_TRUE(testing::wait_for([&] {
        for (QPushButton* button : window_.findChildren<QPushButton*>()) {
            if (button->text() == "Cancel" && button->isVisible()) cancel = button;
        }
        return cancel != nullptr && endless_job_runs_;
    }));
    ASSERT_NE(cancel, nullptr);
    QTest::mouseClick(cancel, Qt::LeftButton);
    EXPECT_TRUE(testing::wait_for([this] { return !window_.busy(); }));
    EXPECT_TRUE(window_.has_patient());
    EXPECT_FALSE(cancel->isVisible());
    EXPECT_EQ(window_.messages().text(), QString());
}

TEST_F(Window, closing_in_the_middle_of_a_job_ends_it) {
    window_.open(folder_.filePath("endless"));
    ASSERT_TRUE(testing::wait_for([this] { return endless_job_runs_.load(); }));
    window_.close();
    EXPECT_FALSE(window_.busy());
}

TEST_F(Window, a_dropped_file_that_cannot_be_read_says_what_where_and_what_to_do) {
    QMimeData data;
    const QString bad = folder_.filePath(QString::fromUtf8("kein_CT_Größe_肝.nii"));
    data.setUrls({QUrl::fromLocalFile(bad)});
    QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, {});
    // QApplication delivers drops only in the course of a drag.
    static_cast<QObject&>(window_).event(&drop);
    EXPECT_TRUE(testing::wait_for([this] { return !window_.messages().text().isEmpty(); }));
    const QString text = window_.messages().text();
    EXPECT_TRUE(text.contains("This is no image")) << text.toStdString();
    EXPECT_TRUE(text.contains(bad)) << text.toStdString();
    EXPECT_TRUE(text.contains("give a CT"));
    EXPECT_FALSE(window_.has_patient());
    EXPECT_TRUE(settings_.recent_files().isEmpty());
}

TEST_F(Window, saves_the_picture_it_shows_under_any_name_and_names_the_folder_it_cannot_write) {
    open_built_in();
    const QString file = folder_.filePath(QString::fromUtf8("Bild_ä_肝.png"));
    window_.save_picture(file);
    const QImage saved(file);
    EXPECT_EQ(saved.size(), pixel_size(window_.view().size(), window_.view().devicePixelRatioF()));
    const QString nowhere = folder_.filePath("no/such/folder");
    EXPECT_THROW(window_.save_picture(nowhere + "/a.png"), InputError);
    EXPECT_FALSE(QFileInfo::exists(folder_.filePath("no"))) << "no folder is made unasked";
    EXPECT_THROW(window_.save_picture("/proc/hepatica/a.png"), InputError);
}

// Whose dialogs are answered by clicks on buttons of a text and by names of files, in this order.
class ArchiveWindow : public Window {
  protected:
    void archive(QStringList answers) {
        open_built_in();
        QTimer answering;
        QObject::connect(&answering, &QTimer::timeout, [&answers] {
            QWidget* asking = QApplication::activeModalWidget();
            if (asking == nullptr || answers.isEmpty()) return;
            if (auto* dialog = qobject_cast<QFileDialog*>(asking)) {
                dialog->findChild<QLineEdit*>()->setText(answers.takeFirst());
                QMetaObject::invokeMethod(dialog, "accept", Qt::QueuedConnection);
                return;
            }
            for (auto* button : asking->findChildren<QAbstractButton*>())
                if (button->text() == answers.front()) {
                    answers.removeFirst();
                    return button->click();
                }
        });
        answering.start(20);
        QAction& action = window_.actions()[ActionId::archive_case];
        EXPECT_TRUE(action.isEnabled());
        action.trigger();
        ASSERT_TRUE(testing::wait_for([this] { return !window_.busy(); }));
        EXPECT_TRUE(answers.isEmpty());
    }
};

// Where the CT lies is asked where nobody knows; a file in its folder is enough.
TEST_F(ArchiveWindow, asks_for_the_file_of_a_ct_whose_place_nobody_knows) {
    const QString slice = folder_.filePath("slice.dcm");
    QFile(slice).open(QIODevice::WriteOnly);
    archive({"&Export…", "File…", slice, folder_.filePath("vessels")});
    EXPECT_EQ(archived_[0], to_path(folder_.path()));
    EXPECT_EQ(archived_[1], to_path(folder_.filePath("vessels.dcm")));
}

TEST_F(ArchiveWindow, takes_the_folder_of_a_dicom_series) {
    archive({"&Export…", "Folder…", folder_.path(), folder_.filePath("vessels")});
    EXPECT_EQ(archived_[0], to_path(folder_.path()));
}

// It names the patient: that is said before anything is asked, and may be refused.
TEST_F(ArchiveWindow, writes_nothing_that_names_the_patient_unless_told_to) {
    archive({QMessageBox::tr("Cancel")});
    EXPECT_EQ(archived_[1], std::filesystem::path());
}

TEST_F(Window, saves_the_case_beside_its_work) {
    open_built_in();
    window_.save_case(folder_.filePath("p.hep"));
    EXPECT_TRUE(testing::wait_for([this] { return !window_.busy(); }));
    EXPECT_EQ(saved_.filename(), "p.hep");
    EXPECT_EQ(settings_.recent_files().size(), 1);
}

// The picture names the case, too: it is drawn anew although nothing moves.
TEST_F(Window, the_view_names_the_case_as_it_was_saved) {
    open_built_in();
    int pictures = 0;
    window_.view().on_picture([&pictures](const PictureTime&) { ++pictures; });
    window_.view().draw_again();  // and once more when it rests
    ASSERT_TRUE(testing::wait_for([&] { return pictures >= 2; }));
    window_.save_case(folder_.filePath("Another name.hep"));
    ASSERT_TRUE(testing::wait_for([this] { return !window_.busy(); }));
    EXPECT_TRUE(testing::wait_for([&] { return pictures >= 3; }));
}

TEST_F(Window, keys_choose_the_tool_and_turn_the_view) {
    open_built_in();
    QTest::keyClick(&window_, Qt::Key_2);
    EXPECT_EQ(window_.view().mouse().mode(), MouseMode::inject);
    QTest::keyClick(&window_, Qt::Key_1);
    EXPECT_EQ(window_.view().mouse().mode(), MouseMode::pull);
    const QPoint front = on_widget(Vec3(30, 0, 40));
    QTest::keyClick(&window_, Qt::Key_P);
    EXPECT_GT((on_widget(Vec3(30, 0, 40)) - front).manhattanLength(), 20);
}

TEST_F(Window, the_middle_of_the_window_cannot_float) {
    EXPECT_TRUE(window_.centralWidget()->isAncestorOf(&window_.view()));
    EXPECT_FALSE(window_.view().isWindow());
}

// Side by side they would make the window wider than a small screen.
TEST_F(Window, CurvesAndBranchesStandOneBehindTheOther) {
    const auto dock = [this](const QString& title) -> QDockWidget& {
        for (auto* one : window_.findChildren<QDockWidget*>())
            if (one->windowTitle() == title) return *one;
        throw std::runtime_error("there is no such dock");
    };
    const auto in_front = [](const QDockWidget& one) { return !one.visibleRegion().isEmpty(); };
    open_built_in();
    QTest::keyClick(&window_, Qt::Key_F6);
    ASSERT_TRUE(testing::wait_for([&] { return in_front(dock("Branches")); }));
    QTest::keyClick(&window_, Qt::Key_F8);
    ASSERT_TRUE(testing::wait_for([&] { return in_front(dock("Curves")); }));
    EXPECT_FALSE(in_front(dock("Branches")));
    EXPECT_LE(window_.minimumSizeHint().width(), 1280);
    QTest::keyClick(&window_, Qt::Key_F6);  // to the front again
    ASSERT_TRUE(testing::wait_for([&] { return in_front(dock("Branches")); }));
    QTest::keyClick(&window_, Qt::Key_F6);  // away
    ASSERT_TRUE(testing::wait_for([&] { return in_front(dock("Curves")); }));
    EXPECT_TRUE(dock("Branches").isHidden());
}

class Layout : public testing::FakeWindowTest {};

TEST_F(Layout, comes_back_with_the_next_window) {
    window_.resize(900, 640);
    window_.findChild<QDockWidget*>("Simulation")->hide();
    window_.addDockWidget(Qt::LeftDockWidgetArea, window_.findChild<QDockWidget*>("Injection"));
    ASSERT_TRUE(window_.close());
    MainWindow next(settings_, {}, answers());
    next.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&next, testing::patience_ms));
    EXPECT_EQ(next.size(), QSize(900, 640));
    EXPECT_TRUE(next.findChild<QDockWidget*>("Simulation")->isHidden());
    EXPECT_EQ(next.dockWidgetArea(next.findChild<QDockWidget*>("Injection")),
              Qt::LeftDockWidgetArea);
}

// There is no window manager here, and so no title bar that would need room.
TEST_F(Layout, lies_no_lower_at_the_next_start) {
    const QRect place(window_.screen()->availableGeometry().topLeft(), QSize(900, 640));
    window_.setGeometry(place);
    ASSERT_TRUE(testing::wait_for([&] { return window_.frameGeometry() == place; }));
    ASSERT_TRUE(window_.close());
    for (int start = 0; start < 2; ++start) {
        MainWindow next(settings_, {}, answers());
        next.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&next, testing::patience_ms));
        EXPECT_TRUE(testing::wait_for([&] { return next.frameGeometry() == place; }))
            << next.frameGeometry().top() << " at start " << start;
        ASSERT_TRUE(next.close());
    }
}

TEST_F(Layout, safe_mode_begins_with_the_usual_one_and_changes_no_setting) {
    window_.findChild<QDockWidget*>("Simulation")->hide();
    ASSERT_TRUE(window_.close());
    const QByteArray kept = settings_.window_layout();
    ASSERT_FALSE(kept.isEmpty());
    Settings safe(Settings::Mode::safe);
    MainWindow next(safe, {}, answers());
    next.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&next, testing::patience_ms));
    EXPECT_FALSE(next.findChild<QDockWidget*>("Simulation")->isHidden());
    next.findChild<QDockWidget*>("Injection")->hide();
    ASSERT_TRUE(next.close());
    EXPECT_TRUE(safe.window_layout().isEmpty());
    EXPECT_EQ(settings_.window_layout(), kept);
}

}  // namespace
}  // namespace hepatica
