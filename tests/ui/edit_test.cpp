// SPDX-License-Identifier: GPL-3.0-or-later
// Correcting a patient's tree in the window, as a person does.
#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QTemporaryDir>
#include <QTest>

#include "tests/patient/parted_patient.h"
#include "ui/main_window.h"
#include "ui/message_bar.h"
#include "ui/paths.h"
#include "ui/pixel_mapping.h"
#include "ui/vtk_widget.h"

namespace hepatica {
namespace {

class Editing : public ::testing::Test {
  protected:
    Editing()
        : settings_(folder_.filePath("settings.ini")),
          window_(settings_,
                  {[](const OpenRequest&, Job& job) {
                       auto patient =
                           std::make_shared<const PatientCase>(test::patient_with_bridges());
                       return play(std::move(patient), job);
                   },
                   [this](const std::filesystem::path& path, const PatientCase& patient) {
                       write_case(path, patient);
                       saved_ = patient;
                   }}) {
        window_.resize(1100, 760);
        window_.show();
        if (!QTest::qWaitForWindowExposed(&window_)) ADD_FAILURE() << "the window did not appear";
        QApplication::setActiveWindow(&window_);
        window_.open(OpenRequest{true, {}});
        wait();
    }

    void wait() {
        const bool done = QTest::qWaitFor(
            [this] {
                return window_.has_patient() && !window_.busy() &&
                       !window_.frame().positions_mm.empty();
            },
            60000);
        EXPECT_TRUE(done);
        paint();
    }
    void paint() {
        QTest::qWait(80);
        window_.view().grabFramebuffer();
    }
    QPoint on_widget(const Vec3& point_mm) {
        return point_at(window_.view().scene().pixel_of(point_mm),
                        window_.view().devicePixelRatioF())
            .toPoint();
    }
    void click(const Vec3& point_mm) {
        QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(point_mm));
        wait();
    }
    // What would be written now.
    const PatientCase& saved() {
        window_.save_case(folder_.filePath("p.hep"));
        wait();
        return saved_;
    }
    void choose_tool(const QString& name) {
        auto* tools = window_.findChild<QComboBox*>("EditTool");
        ASSERT_NE(tools, nullptr);
        ASSERT_GE(tools->findText(name), 0);
        tools->setCurrentIndex(tools->findText(name));
    }

    QTemporaryDir folder_;
    Settings settings_;
    PatientCase saved_;
    MainWindow window_;
};

TEST_F(Editing, a_click_on_a_dashed_line_bridges_the_gap_and_can_be_undone) {
    ASSERT_EQ(roots(saved().tree).size(), 2u);
    const Vec3 middle = test::last_gap[1];
    ASSERT_GE(window_.view().scene().bridge_at(
                  pixel_at(on_widget(middle), window_.view().devicePixelRatioF()), 6.0),
              0);
    click(middle);
    EXPECT_EQ(window_.messages().text(), "");
    EXPECT_EQ(roots(saved().tree).size(), 1u);
    EXPECT_GT(bridged_length_mm(saved_.tree), 5.0);
    EXPECT_EQ(saved_.corrections.edits.size(), 1u);
    EXPECT_FALSE(window_.isWindowModified());  // it has just been saved

    window_.actions()[ActionId::undo_edit].trigger();
    wait();
    EXPECT_TRUE(window_.isWindowModified());
    EXPECT_EQ(roots(saved().tree).size(), 2u);
    EXPECT_TRUE(saved_.corrections.edits.empty());
    window_.actions()[ActionId::redo_edit].trigger();
    wait();
    EXPECT_EQ(roots(saved().tree).size(), 1u);
}

TEST_F(Editing, a_click_in_edit_mode_does_what_the_panel_says) {
    const std::size_t before = saved().tree.segments.size();
    window_.actions()[ActionId::edit_mode].trigger();
    choose_tool("Delete a branch");
    click(Vec3(-8.6, 28, 4.4));                           // the left branch
    EXPECT_EQ(saved().tree.segments.size(), before - 2);  // the trunk goes on into the right one
    choose_tool("Give to a system");
    click(Vec3(37, 54.5, 4));  // the vessel apart
    ASSERT_EQ(saved().corrections.edits.size(), 2u);
    EXPECT_EQ(saved_.corrections.edits[1].kind, TreeEditKind::reassign_system);
    // A place beside every vessel is no place.
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, QPoint(5, 5));
    wait();
    EXPECT_EQ(saved().corrections.edits.size(), 2u);
}

TEST_F(Editing, an_edit_that_leaves_nothing_is_refused_and_the_patient_stays) {
    window_.actions()[ActionId::edit_mode].trigger();
    choose_tool("Delete a branch");
    click(Vec3(37, 54.5, 4));
    ASSERT_EQ(roots(saved().tree).size(), 1u);
    click(Vec3(0, 10, 1.5));  // the trunk, and all that hangs on it
    EXPECT_TRUE(window_.messages().text().contains("nothing of the tree"));
    EXPECT_EQ(saved().corrections.edits.size(), 1u);
    EXPECT_FALSE(saved_.tree.segments.empty());
}

}  // namespace
}  // namespace hepatica
