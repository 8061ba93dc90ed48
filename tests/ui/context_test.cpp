// SPDX-License-Identifier: GPL-3.0-or-later
// What stands around the vessels, the liver, and the plane that opens the view.
#include <gtest/gtest.h>

#include "tests/ui/fake_window_test.h"
#include "ui/clip_control.h"
#include "ui/liver_keeper.h"
#include "ui/message_bar.h"
#include "ui/vtk_widget.h"

namespace hepatica::testing {
namespace {

std::shared_ptr<PatientCase> patient_with_liver() {
    auto patient = std::make_shared<PatientCase>();
    Grid grid;
    grid.dims = {20, 20, 20};
    grid.spacing_mm = Vec3::Constant(3.0);
    patient->organs = Mask(grid);
    for (int z = 5; z < 15; ++z)
        for (int y = 5; y < 15; ++y)
            for (int x = 5; x < 15; ++x) patient->organs.at(x, y, z) = organ_label::liver;
    return patient;
}

class Liver : public ::testing::Test {
  protected:
    LiverKeeper keeper_{{[this](const TriangleMesh& surface) {
                             shown_ = static_cast<int>(surface.triangles.size());
                             ++times_;
                         },
                         [this] { ++none_; },
                         [this](const Failure& failure) { failed_ = failure.problem; }}};
    int shown_ = -1, times_ = 0, none_ = 0;
    std::string failed_;
};

TEST_F(Liver, IsMadeOnceAndOnlyWhereItIsWanted) {
    keeper_.show_patient(patient_with_liver(), {});
    EXPECT_FALSE(keeper_.making());
    EXPECT_EQ(shown_, 0);  // that of the patient before is gone
    keeper_.set_wanted(true);
    ASSERT_TRUE(wait_for([this] { return shown_ > 0; }));
    const int times = times_;
    keeper_.set_wanted(false);
    keeper_.set_wanted(true);
    EXPECT_FALSE(keeper_.making());
    EXPECT_EQ(times_, times);
    // The next patient's is made at once.
    keeper_.show_patient(patient_with_liver(), {});
    EXPECT_EQ(shown_, 0);
    ASSERT_TRUE(wait_for([this] { return shown_ > 0; }));
    EXPECT_EQ(none_, 0);
}

TEST_F(Liver, IsMissedWhereTheCaseKnowsNone) {
    keeper_.show_patient(std::make_shared<PatientCase>(), {});
    keeper_.set_wanted(true);
    ASSERT_TRUE(wait_for([this] { return none_ == 1; }));
    EXPECT_EQ(shown_, 0);
}

TEST_F(Liver, SaysWhatIsWrongWithTheCaseOnDisk) {
    keeper_.show_patient(std::make_shared<PatientCase>(), "/nowhere/to/be/found.hep");
    keeper_.set_wanted(true);
    ASSERT_TRUE(wait_for([this] { return !failed_.empty(); }));
    EXPECT_FALSE(keeper_.making());
}

class Context : public FakeWindowTest {};

TEST_F(Context, OpensTheViewAcrossTheLineOfSightAndClosesIt) {
    open_built_in();
    const ClipControl& clip = window_.view().mouse().clip();
    const ViewAxes axes = window_.view().scene().axes();
    QTest::keyClick(&window_, Qt::Key_O);
    ASSERT_TRUE(clip.is_open());
    EXPECT_LT((clip.plane()->inward - axes.forward).norm(), 1e-12);
    EXPECT_LT((clip.plane()->point_mm - axes.focus_mm).norm(), 1e-12);
    QTest::keyClick(&window_, Qt::Key_D);
    EXPECT_NEAR((clip.plane()->point_mm - axes.focus_mm).dot(axes.forward), clip_step_mm, 1e-12);
    QTest::keyClick(&window_, Qt::Key_D, Qt::ShiftModifier);
    QTest::keyClick(&window_, Qt::Key_D, Qt::ShiftModifier);
    EXPECT_NEAR((clip.plane()->point_mm - axes.focus_mm).dot(axes.forward), -clip_step_mm, 1e-12);
    // It stays in the patient when the view is turned.
    QTest::keyClick(&window_, Qt::Key_L);
    EXPECT_LT((clip.plane()->inward - axes.forward).norm(), 1e-12);
    QTest::keyClick(&window_, Qt::Key_O);
    EXPECT_FALSE(clip.is_open());
}

TEST_F(Context, LetsTheMouseMeetOnlyWhatIsDrawn) {
    open_built_in();
    SceneView& scene = window_.view().scene();
    const Vec3 on_trunk(0, 0, half_way_up_the_trunk_mm);
    ASSERT_GE(scene.pick(scene.pixel_of(on_trunk)).triangle, 0);
    const double before = scene.pick(scene.pixel_of(on_trunk)).position_mm.dot(Vec3::UnitY());
    MouseTool& mouse = window_.view().mouse();
    mouse.clip().open_at(on_trunk);  // through the trunk's axis: its back is left
    const SurfacePick behind = scene.pick(scene.pixel_of(on_trunk));
    ASSERT_GE(behind.triangle, 0);
    EXPECT_GT(behind.position_mm.y(), on_trunk.y());
    EXPECT_LT(before, on_trunk.y());
    mouse.wheel(50.0, {.alt = true});  // 100 mm deeper: nothing is left
    EXPECT_LT(scene.pick(scene.pixel_of(on_trunk)).triangle, 0);
    mouse.clip().close();
    EXPECT_NEAR(scene.pick(scene.pixel_of(on_trunk)).position_mm.y(), before, 1e-9);
}

TEST_F(Context, IsWholeAgainForTheNextPatient) {
    open_built_in();
    QTest::keyClick(&window_, Qt::Key_O);
    ASSERT_TRUE(window_.view().mouse().clip().is_open());
    open_built_in();
    EXPECT_FALSE(window_.view().mouse().clip().is_open());
    EXPECT_FALSE(window_.actions()[ActionId::toggle_clip].isChecked());
}

TEST_F(Context, SaysThatThePatientHasNoLiver) {
    open_built_in();
    QTest::keyClick(&window_, Qt::Key_V);
    EXPECT_TRUE(wait_for([this] {
        return window_.messages().isVisible() &&
               window_.messages().text().contains("knows no liver");
    }));
}

}  // namespace
}  // namespace hepatica::testing
