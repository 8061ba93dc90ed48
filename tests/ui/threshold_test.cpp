// SPDX-License-Identifier: GPL-3.0-or-later
// More or fewer vessels by a slider, over the slices of a synthetic patient.
#include "ui/slices/threshold_dialog.h"

#include <gtest/gtest.h>

#include <QHideEvent>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <algorithm>

#include "tests/reconstruction/noisy_patient.h"
#include "tests/ui/slices_test.h"

namespace hepatica {
namespace {

class Threshold : public ::testing::Test {
  protected:
    static void SetUpTestSuite() {
        patient_ =
            std::make_unique<testing_support::NoisyPatient>(testing_support::noisy_patient());
        ct_ = std::make_shared<const Volume>(patient_->truth.ct);
    }
    static void TearDownTestSuite() {
        patient_.reset();
        ct_.reset();
    }
    static const Mask& found() { return patient_->found; }

    Threshold()
        : dialog_(scene_, {[this] { return [organs = organs_] { return organs; }; },
                           [this](std::shared_ptr<const Volume> ct, Mask vessels) {
                               remade_ct_ = std::move(ct);
                               remade_ = std::move(vessels);
                           },
                           [this](const Failure& failure) { failed_ = failure.problem; }}) {
        organs_ = patient_->organs;
    }

    void open() {
        scene_.show(ct_, found(), patient_->truth.tree);
        dialog_.show();
        ASSERT_TRUE(testing::wait_for([this] { return !dialog_.working(); }));
    }
    void choose(int percent) {
        dialog_.findChild<QSlider*>("lineShare")->setValue(percent);
        ASSERT_TRUE(testing::wait_for([this] { return !dialog_.working(); }));
    }
    QPushButton& rebuild() { return *dialog_.findChild<QPushButton*>("rebuildByThreshold"); }
    QString state() { return dialog_.findChild<QLabel*>("thresholdState")->text(); }
    static auto count(const Mask& mask, std::uint8_t label) {
        return std::ranges::count(mask.voxels, label);
    }

    static inline std::unique_ptr<testing_support::NoisyPatient> patient_;
    static inline std::shared_ptr<const Volume> ct_;

    Mask organs_;
    SliceScene scene_;
    std::shared_ptr<const Volume> remade_ct_;
    Mask remade_;
    std::string failed_;
    ThresholdDialog dialog_;
};

TEST_F(Threshold, ShowsInTheSlicesWhatItWouldFind) {
    open();
    EXPECT_TRUE(dialog_.measured());
    EXPECT_TRUE(scene_.preview().voxels.empty());
    EXPECT_FALSE(rebuild().isEnabled());
    choose(80);
    EXPECT_GT(count(scene_.shown_systems(), painted_label), 0);
    EXPECT_EQ(count(scene_.systems(), painted_label), 0) << "nothing has changed yet";
    EXPECT_TRUE(rebuild().isEnabled());
    EXPECT_TRUE(state().contains("mL of vessels")) << state().toStdString();
    choose(130);
    EXPECT_EQ(count(scene_.shown_systems(), painted_label), 0);
    EXPECT_GT(count(scene_.shown_systems(), 0), count(scene_.systems(), 0));
    choose(100);
    EXPECT_TRUE(scene_.preview().voxels.empty());
    EXPECT_FALSE(rebuild().isEnabled());
}

TEST_F(Threshold, RebuildsWhatTheSlicesShow) {
    open();
    choose(80);
    const Mask shown = scene_.shown_systems();
    rebuild().click();
    EXPECT_EQ(remade_ct_, ct_);
    const auto unknown = static_cast<std::uint8_t>(number_of(VascularSystem::unknown));
    for (std::size_t i = 0; i < shown.voxels.size(); ++i)
        ASSERT_EQ(remade_.voxels[i], shown.voxels[i] == painted_label ? unknown : shown.voxels[i]);
    // Once they are there, the slider stands for them.
    scene_.set_systems(remade_);
    EXPECT_TRUE(scene_.preview().voxels.empty());
    ASSERT_TRUE(testing::wait_for([this] { return !dialog_.working(); }));
    EXPECT_EQ(dialog_.choice().line_share, 0.8);
    EXPECT_TRUE(state().contains("by 80 % of the usual")) << state().toStdString();
    EXPECT_FALSE(rebuild().isEnabled());
}

// A threshold means the same after a rebuild, also where the dialog was closed meanwhile.
TEST_F(Threshold, LeadsBackByTheUsualOneAfterARebuild) {
    open();
    choose(80);
    rebuild().click();
    scene_.set_systems(remade_);
    dialog_.hide();
    dialog_.show();
    ASSERT_TRUE(testing::wait_for([this] { return !dialog_.working(); }));
    EXPECT_EQ(dialog_.choice().line_share, 0.8);
    EXPECT_TRUE(scene_.preview().voxels.empty());
    choose(100);
    EXPECT_EQ(scene_.shown_systems().voxels, found().voxels);
    ASSERT_TRUE(rebuild().isEnabled());
    rebuild().click();
    EXPECT_EQ(remade_.voxels, found().voxels);
    scene_.set_systems(remade_);
    ASSERT_TRUE(testing::wait_for([this] { return !dialog_.working(); }));
    EXPECT_EQ(dialog_.choice().line_share, 1.0);
    EXPECT_FALSE(rebuild().isEnabled());
}

// As after an undo of the rebuild.
TEST_F(Threshold, KnowsTheVesselsFromBeforeARebuild) {
    open();
    choose(80);
    rebuild().click();
    scene_.set_systems(remade_);
    ASSERT_TRUE(testing::wait_for([this] { return !dialog_.working(); }));
    scene_.set_systems(found());
    ASSERT_TRUE(testing::wait_for([this] { return !dialog_.working(); }));
    EXPECT_EQ(dialog_.choice().line_share, 1.0);
    EXPECT_TRUE(state().contains("by 100 % of the usual")) << state().toStdString();
    EXPECT_FALSE(rebuild().isEnabled());
}

// What a hand erased of the vessels that were rebuilt is gone by every threshold.
TEST_F(Threshold, KeepsWhatAHandChangedAfterARebuild) {
    open();
    choose(80);
    rebuild().click();
    scene_.set_systems(remade_);
    ASSERT_TRUE(testing::wait_for([this] { return !dialog_.working(); }));
    ASSERT_NE(value_at(scene_.systems(), scene_.crosshair_mm()), 0);
    scene_.brush().set_mode(BrushMode::erases);
    scene_.brush().begin(scene_.crosshair_mm());
    scene_.brush().lift();
    choose(100);
    EXPECT_EQ(value_at(scene_.shown_systems(), scene_.crosshair_mm()), 0);
    EXPECT_LT(count(found(), 0), count(scene_.shown_systems(), 0));
    choose(80);
    EXPECT_TRUE(scene_.preview().voxels.empty()) << "that is what there is";
}

// However often it is moved while one choice is being made.
TEST_F(Threshold, EndsWithTheLastChoice) {
    open();
    choose(80);
    const Mask expected = scene_.shown_systems();
    for (const int percent : {125, 75, 90, 115}) dialog_.findChild<QSlider*>()->setValue(percent);
    choose(80);
    EXPECT_EQ(scene_.shown_systems().voxels, expected.voxels);
    dialog_.findChild<QSpinBox*>("refinement")->setValue(2);
    ASSERT_TRUE(testing::wait_for([this] { return !dialog_.working(); }));
    EXPECT_NE(scene_.shown_systems().voxels, expected.voxels);
}

// A rebuilding takes a while, and so does reading a CT.
TEST_F(Threshold, KeepsWhatAHandChoseWhileItWaits) {
    dialog_.show();
    ASSERT_EQ(state(), "Waiting for the CT");
    dialog_.findChild<QSlider*>("lineShare")->setValue(80);
    open();
    EXPECT_EQ(dialog_.choice().line_share, 0.8);
    EXPECT_GT(count(scene_.shown_systems(), painted_label), 0);
    rebuild().click();
    choose(120);
    scene_.set_systems(remade_);
    ASSERT_TRUE(testing::wait_for([this] { return !dialog_.working(); }));
    EXPECT_EQ(dialog_.choice().line_share, 1.2);
    EXPECT_TRUE(state().contains("by 80 % of the usual")) << state().toStdString();
    EXPECT_TRUE(rebuild().isEnabled());
}

TEST_F(Threshold, LeavesTheSlicesToABrush) {
    open();
    choose(80);
    scene_.brush().set_mode(BrushMode::erases);
    scene_.brush().begin(scene_.crosshair_mm());
    EXPECT_TRUE(scene_.preview().voxels.empty());
    EXPECT_EQ(dialog_.choice().line_share, 1.0);
    EXPECT_EQ(count(scene_.shown_systems(), painted_label), 0);
    // And is tried on what is left of the vessels.
    choose(80);
    EXPECT_EQ(value_at(scene_.shown_systems(), scene_.crosshair_mm()), 0);
}

TEST_F(Threshold, TakesInAStrokeThatIsMadeWhileItWorks) {
    open();
    dialog_.findChild<QSlider*>("lineShare")->setValue(80);
    ASSERT_TRUE(dialog_.working());
    scene_.brush().set_mode(BrushMode::erases);
    scene_.brush().begin(scene_.crosshair_mm());
    scene_.brush().lift();
    ASSERT_TRUE(testing::wait_for([this] { return !dialog_.working(); }));
    EXPECT_GT(count(scene_.shown_systems(), painted_label), 0);
    EXPECT_EQ(value_at(scene_.systems(), scene_.crosshair_mm()), 0);
    EXPECT_EQ(value_at(scene_.shown_systems(), scene_.crosshair_mm()), 0);
}

TEST_F(Threshold, LeavesNothingToTheNextPatient) {
    open();
    choose(80);
    scene_.clear();
    EXPECT_FALSE(rebuild().isEnabled());
    EXPECT_EQ(dialog_.choice().line_share, 1.0);
    const auto other = std::make_shared<const Volume>(*ct_);
    scene_.show(other, found(), patient_->truth.tree);
    EXPECT_TRUE(dialog_.working());
    EXPECT_FALSE(rebuild().isEnabled());
    ASSERT_TRUE(testing::wait_for([this] { return !dialog_.working(); }));
    EXPECT_TRUE(dialog_.measured());
    EXPECT_TRUE(scene_.preview().voxels.empty());
}

TEST_F(Threshold, KeepsItsChoiceWhileTheWindowIsMinimised) {
    open();
    choose(80);
    QHideEvent minimised;
    QSpontaneKeyEvent::setSpontaneous(&minimised);
    qApp->notify(&dialog_, &minimised);  // sendEvent() would make it one of the program's
    EXPECT_TRUE(dialog_.measured());
    EXPECT_EQ(dialog_.choice().line_share, 0.8);
}

TEST_F(Threshold, ForgetsItsLinesWhenItIsClosed) {
    open();
    choose(80);
    dialog_.hide();
    EXPECT_FALSE(dialog_.measured());
    EXPECT_TRUE(scene_.preview().voxels.empty());
    EXPECT_EQ(dialog_.choice().line_share, 1.0);
}

TEST_F(Threshold, WaitsForTheCtAndSaysWhatIsMissing) {
    dialog_.show();
    EXPECT_FALSE(dialog_.working());
    EXPECT_EQ(state(), "Waiting for the CT");
    scene_.show(ct_, {}, patient_->truth.tree);
    EXPECT_FALSE(dialog_.working());
    EXPECT_EQ(state(), "This case knows no voxels of its vessels");
    scene_.clear();
    organs_ = {};
    const auto air = std::make_shared<const Volume>(ct_->grid, std::int16_t{-1000});
    scene_.show(air, found(), patient_->truth.tree);
    ASSERT_TRUE(testing::wait_for([this] { return !dialog_.working(); }));
    EXPECT_FALSE(failed_.empty());
    EXPECT_EQ(state().toStdString(), failed_);
    EXPECT_FALSE(rebuild().isEnabled());
}

class ThresholdInWindow : public testing::SlicesTest {};

TEST_F(ThresholdInWindow, OpensWithTheSlices) {
    views().show_patient(patient_, {}, file_);
    QTest::keyClick(&window_, Qt::Key_F4);
    EXPECT_TRUE(views().slices_visible());
    EXPECT_TRUE(views().threshold().isVisible());
    ASSERT_TRUE(
        testing::wait_for([this] { return !scene().empty() && !views().threshold().working(); }));
    EXPECT_FALSE(views().threshold().measured()) << "there is no liver in that CT";
}

}  // namespace
}  // namespace hepatica
