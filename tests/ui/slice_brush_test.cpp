// SPDX-License-Identifier: GPL-3.0-or-later
// Vessels painted and erased in the slices by mouse and keys.
#include "core/image/filters.h"
#include "tests/ui/slices_test.h"
#include "ui/message_bar.h"
#include "ui/message_log.h"
#include "ui/slices/stroke_place.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>

namespace hepatica {
namespace {

// The brush of 4 mm in hand, over the axial slice through the middle.
class BrushOnSlices : public testing::SlicesTest {
  protected:
    void begin() {
        show_slices();
        EXPECT_FALSE(rebuild().isVisible());
        before_ = scene().systems();
        take(painting);
        window_.findChild<QDoubleSpinBox*>("brushRadius")->setValue(4.0);
        scene().set_crosshair(ct_.grid.to_mm(20, 25, 30));
    }
    // Of a patient whose liver fills the lower right corner of the slice.
    void begin_beside_a_liver() {
        auto patient = std::make_shared<PatientCase>(*patient_);
        patient->organs = Mask(ct_.grid);
        for (int k = 0; k < 60; ++k)
            for (int j = 0; j < 50; ++j)
                for (int i = 30; i < 40; ++i) patient->organs.voxels[ct_.grid.offset(i, j, k)] = 1;
        patient_ = patient;
        begin();
        ASSERT_TRUE(
            testing::wait_for([this] { return !scene().tumours().organs().voxels.empty(); }));
    }
    // Of a patient whose case keeps organs in a box within the CT, which the liver fills.
    void begin_with_a_box_about_the_liver() {
        auto patient = std::make_shared<PatientCase>(*patient_);
        patient->organs =
            crop(Mask(ct_.grid, organ_label::liver), IndexBox{{10, 15, 20}, {30, 35, 40}});
        patient_ = patient;
        begin();
        ASSERT_TRUE(
            testing::wait_for([this] { return !scene().tumours().organs().voxels.empty(); }));
    }
    void take(int purpose) { emit choice().activated(purpose); }
    // From left to right, with the button held.
    void stroke() {
        press();
        move();
        release();
    }
    // What Qt makes of a second press right after the first.
    void press_again() { QTest::mouseDClick(&axial(), Qt::LeftButton, {}, place_of_column(10)); }
    void press() { QTest::mousePress(&axial(), Qt::LeftButton, {}, place_of_column(10)); }
    void release() { QTest::mouseRelease(&axial(), Qt::LeftButton, {}, place_of_column(15)); }
    void click_other(Qt::MouseButton button) {
        QTest::mouseClick(&axial(), button, {}, place_of_column(10));
    }
    void move() {
        const QPointF to = place_of_column(15);
        QMouseEvent event(QEvent::MouseMove, to, axial().mapToGlobal(to), Qt::NoButton,
                          Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&axial(), &event);
    }
    // What the strokes make of the voxels from before.
    Mask painted() {
        Mask mask = before_;
        for (const BrushStroke& stroke : brush().strokes()) apply(stroke, painted_label, mask);
        return mask;
    }
    bool said(const QString& words) {
        return window_.findChild<QLabel*>("slicePlace")->text().contains(words);
    }
    SliceView& axial() { return view(SliceDirection::axial); }
    const MaskBrush& brush() { return scene().brush(); }
    QComboBox& choice() { return *window_.findChild<QComboBox*>("measure"); }
    QPushButton& rebuild() { return *window_.findChild<QPushButton*>("rebuildVessels"); }

    static constexpr int crosshair = 0, painting = 6, erasing = 7;
    Mask before_;

  private:
    QPoint place_of_column(int i) { return axial().place_of(ct_.grid.to_mm(i, 25, 30)).toPoint(); }
};

TEST_F(BrushOnSlices, ShowsAtOnceWhatItPaints) {
    begin();
    EXPECT_EQ(choice().currentText(), "Paint vessels");
    stroke();
    ASSERT_EQ(brush().strokes().size(), 1u);
    EXPECT_EQ(brush().strokes()[0].path_mm.size(), 2u);
    EXPECT_EQ(scene().systems().voxels, painted().voxels) << "while the mouse led it, too";
    EXPECT_EQ(scene().systems().at(12, 25, 30), painted_label);
    EXPECT_EQ(scene().vessels().at(12, 25, 30), 255);
    EXPECT_EQ(scene().systems().at(12, 25, 31), painted_label) << "a ball, not a disc";
    EXPECT_EQ(scene().crosshair_mm(), ct_.grid.to_mm(20, 25, 30)) << "and nothing else";
    move();
    EXPECT_EQ(brush().strokes()[0].path_mm.size(), 2u) << "lifted, it leaves nothing";
}

TEST_F(BrushOnSlices, BeginsAStrokeHoweverSoonAfterTheLast) {
    begin();
    press();
    release();
    press_again();
    move();
    release();
    ASSERT_EQ(brush().strokes().size(), 2u);
    EXPECT_EQ(brush().strokes()[1].path_mm.size(), 2u);
}

TEST_F(BrushOnSlices, ShowsWhatItPaintsOverVesselsAsPainted) {
    begin();
    for (std::uint8_t& voxel : before_.voxels) voxel = 2;
    scene().set_systems(before_);
    stroke();
    EXPECT_EQ(scene().systems().at(12, 25, 30), painted_label);
    EXPECT_EQ(scene().systems().at(1, 1, 1), 2) << "and nothing else";
}

TEST_F(BrushOnSlices, IsLiftedByNoOtherButton) {
    begin();
    press();
    click_other(Qt::RightButton);
    EXPECT_TRUE(brush().leads());
    click_other(Qt::MiddleButton);
    EXPECT_TRUE(brush().leads());
    move();
    release();
    EXPECT_FALSE(brush().leads());
    ASSERT_EQ(brush().strokes().size(), 1u);
    EXPECT_EQ(brush().strokes()[0].path_mm.size(), 2u);
}

TEST_F(BrushOnSlices, SaysWhereItCannotPaint) {
    begin();
    scene().set_systems(
        Mask(Grid{{4, 4, 4}, Vec3(3, 3, 3), ct_.grid.origin_mm, Mat3::Identity()}, 1));
    stroke();
    EXPECT_TRUE(brush().strokes().empty());
    EXPECT_TRUE(said("Too far from the liver"));
    scene().set_systems({});
    QTest::keyClick(&axial(), Qt::Key_Return);
    EXPECT_TRUE(brush().strokes().empty());
    EXPECT_TRUE(said("knows no voxels"));
    scene().set_systems(before_);
    stroke();
    EXPECT_EQ(scene().systems().voxels, painted().voxels);
}

TEST_F(BrushOnSlices, LeavesNoStrokeWhereNothingWasErased) {
    begin();
    take(erasing);
    stroke();
    EXPECT_TRUE(brush().strokes().empty());
    EXPECT_EQ(scene().systems().voxels, before_.voxels);
    EXPECT_TRUE(said("Nothing erased"));
    EXPECT_FALSE(rebuild().isEnabled());
    take(painting);
    stroke();
    take(erasing);
    stroke();
    EXPECT_EQ(brush().strokes().size(), 2u) << "what was painted is erased";
    EXPECT_EQ(scene().systems().voxels, before_.voxels);
}

// Before the first stroke; the guidance tells of these keys.
TEST_F(BrushOnSlices, IsSizedByKeysInTheListItWasTakenFrom) {
    begin();
    QTest::keyClick(&choice(), Qt::Key_Plus, Qt::ShiftModifier);
    EXPECT_EQ(brush().radius_mm(), 4.5);
    QTest::keyClick(&choice(), Qt::Key_Minus);
    QTest::keyClick(&choice(), Qt::Key_Minus, Qt::KeypadModifier);
    EXPECT_EQ(brush().radius_mm(), 3.5);
    EXPECT_EQ(choice().currentIndex(), painting);
    take(crosshair);
    QTest::keyClick(&choice(), Qt::Key_Plus);
    EXPECT_EQ(brush().radius_mm(), 3.5) << "it is put away";
}

// Smaller, a dab that erases, and back.
TEST_F(BrushOnSlices, IsLedByKeys) {
    begin();
    stroke();
    take(erasing);
    QTest::keyClick(&axial(), Qt::Key_Minus);
    EXPECT_EQ(window_.findChild<QDoubleSpinBox*>("brushRadius")->value(), 3.5);
    // As keyboards have it on which + takes Shift, and as a pad of numbers has it.
    QTest::keyClick(&axial(), Qt::Key_Plus, Qt::ShiftModifier);
    EXPECT_EQ(window_.findChild<QDoubleSpinBox*>("brushRadius")->value(), 4.0);
    QTest::keyClick(&axial(), Qt::Key_Minus, Qt::KeypadModifier);
    EXPECT_EQ(window_.findChild<QDoubleSpinBox*>("brushRadius")->value(), 3.5);
    EXPECT_NE(scene().systems().at(20, 25, 30), 0);
    QTest::keyClick(&axial(), Qt::Key_Return);
    EXPECT_EQ(scene().systems().at(20, 25, 30), 0);
    EXPECT_EQ(brush().strokes().size(), 2u);
    QTest::keyClick(&axial(), Qt::Key_Delete);
    EXPECT_EQ(brush().strokes().size(), 1u);
    EXPECT_EQ(scene().systems().voxels, painted().voxels);
}

TEST_F(BrushOnSlices, AsksToRebuildUntilItIsPutAway) {
    begin();
    EXPECT_TRUE(rebuild().isVisible());
    EXPECT_FALSE(rebuild().isEnabled());
    stroke();
    take(crosshair);
    EXPECT_TRUE(rebuild().isVisible()) << "what was painted waits";
    EXPECT_TRUE(rebuild().isEnabled());
    take(painting);
    QTest::keyClick(&axial(), Qt::Key_Escape);
    EXPECT_EQ(scene().systems().voxels, before_.voxels);
    QTest::keyClick(&axial(), Qt::Key_Escape);
    EXPECT_EQ(choice().currentText(), "Crosshair");
    EXPECT_FALSE(rebuild().isVisible());
}

// As after a correction that gives voxels to another system.
TEST_F(BrushOnSlices, PaintsTheSameOnOtherVoxels) {
    begin();
    QTest::keyClick(&axial(), Qt::Key_Return);
    scene().set_systems(before_);
    EXPECT_EQ(brush().strokes().size(), 1u) << "they are the same";
    before_.voxels[ct_.grid.offset(3, 3, 3)] = 2;
    scene().set_systems(before_);
    EXPECT_EQ(brush().strokes().size(), 1u);
    EXPECT_EQ(scene().systems().voxels, painted().voxels);
    QTest::keyClick(&axial(), Qt::Key_Delete);
    EXPECT_EQ(scene().systems().voxels, before_.voxels);
}

TEST_F(BrushOnSlices, IsTakenBackByTheUndoOfAllElse) {
    begin();
    stroke();
    QTest::keyClick(&axial(), Qt::Key_Return);
    ASSERT_EQ(brush().strokes().size(), 2u);
    EXPECT_TRUE(window_.isWindowModified());
    for (const QListWidget* list : window_.findChildren<QListWidget*>())
        if (list->accessibleName() == "Edits") {
            EXPECT_EQ(list->count(), 2);
        }
    QTest::keyClick(&axial(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(brush().strokes().size(), 1u);
    EXPECT_EQ(scene().systems().voxels, painted().voxels);
    QTest::keyClick(&axial(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(brush().strokes().size(), 2u);
    EXPECT_EQ(scene().systems().voxels, painted().voxels);
    for (int i = 0; i < 2; ++i) QTest::keyClick(&axial(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(brush().strokes().empty());
    EXPECT_EQ(scene().systems().voxels, before_.voxels);
    EXPECT_FALSE(window_.isWindowModified());
}

TEST_F(BrushOnSlices, IsAskedAboutBeforeTheWindowCloses) {
    begin();
    stroke();
    strokes_answer_ = StrokesAnswer::cancel;
    window_.close();
    EXPECT_TRUE(window_.isVisible());
    EXPECT_EQ(strokes_asked_, 1u);
    EXPECT_EQ(scene().systems().voxels, painted().voxels);
    strokes_answer_ = StrokesAnswer::drop;
    window_.close();
    EXPECT_FALSE(window_.isVisible());
}

// What is painted lies far to the left of the liver.
TEST_F(BrushOnSlices, WarnsOfAStrokeFarOutsideTheLiverAndTakesItBack) {
    begin_beside_a_liver();
    scene().set_crosshair(ct_.grid.to_mm(29, 25, 30));
    QTest::keyClick(&axial(), Qt::Key_Return);
    EXPECT_EQ(window_.messages().text(), "") << "beside the liver run its vessels, too";
    stroke();
    ASSERT_EQ(brush().strokes().size(), 2u);
    const QString warning = window_.messages().text();
    EXPECT_TRUE(warning.contains("outside the liver")) << warning.toStdString();
    EXPECT_TRUE(warning.contains("(at 30 mm right, ")) << "and where: " << warning.toStdString();
    EXPECT_FALSE(window_.log().as_text().contains("no longer so"));
    QTest::mouseClick(window_.messages().findChild<QPushButton*>("offer"), Qt::LeftButton);
    EXPECT_EQ(brush().strokes().size(), 1u);
    EXPECT_TRUE(window_.log().as_text().contains("no longer so\tCorrections\tThis stroke lies"))
        << window_.log().as_text().toStdString();
}

// The notice may outlast its stroke.
TEST_F(BrushOnSlices, TakesBackNoOtherStrokeThanTheOneThatIsWarnedOf) {
    begin_beside_a_liver();
    scene().set_crosshair(ct_.grid.to_mm(29, 25, 30));
    QTest::keyClick(&axial(), Qt::Key_Return);
    stroke();
    ASSERT_EQ(brush().strokes().size(), 2u);
    ASSERT_TRUE(window_.messages().text().contains("outside the liver"));
    QTest::keyClick(&axial(), Qt::Key_Z, Qt::ControlModifier);
    ASSERT_EQ(brush().strokes().size(), 1u);
    EXPECT_TRUE(window_.log().as_text().contains("no longer so"));
    QTest::mouseClick(window_.messages().findChild<QPushButton*>("offer"), Qt::LeftButton);
    EXPECT_EQ(brush().strokes().size(), 1u) << "the one beside the liver stays";
    QTest::keyClick(&axial(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_EQ(brush().strokes().size(), 2u);
    EXPECT_FALSE(window_.log().as_text().contains("no longer so")) << "it is so again";
}

TEST_F(BrushOnSlices, SaysThatATumourLiesOutsideTheLiverAndTakesItBack) {
    begin_beside_a_liver();
    constexpr int painting_tumours = 8;
    take(painting_tumours);
    scene().set_crosshair(ct_.grid.to_mm(34, 25, 30));
    QTest::keyClick(&axial(), Qt::Key_Return);
    ASSERT_EQ(scene().tumours().tumours().size(), 1u);
    EXPECT_EQ(window_.messages().text(), "") << "within the liver";
    const double before_ml = scene().tumours().tumours()[0].volume_ml;
    scene().set_crosshair(ct_.grid.to_mm(10, 25, 30));
    QTest::keyClick(&axial(), Qt::Key_Return);
    const QString notice = window_.messages().text();
    EXPECT_TRUE(notice.contains("tumour lies outside the liver")) << notice.toStdString();
    EXPECT_TRUE(notice.contains(" mm headwards)") || notice.contains(" mm feetwards)"))
        << "in words: " << notice.toStdString();
    EXPECT_GT(scene().tumours().tumours()[0].volume_ml, before_ml) << "it is not forbidden";
    QTest::mouseClick(window_.messages().findChild<QPushButton*>("offer"), Qt::LeftButton);
    ASSERT_EQ(scene().tumours().tumours().size(), 1u);
    EXPECT_EQ(scene().tumours().tumours()[0].volume_ml, before_ml);
    EXPECT_TRUE(window_.log().as_text().contains("no longer so\tCorrections\tThis tumour lies"))
        << window_.log().as_text().toStdString();
}

// A case keeps 30 mm about the box, to row 44 of the CT's 50.
TEST_F(BrushOnSlices, SaysThatATumourIsCutOffWhereACaseKeepsNone) {
    begin_with_a_box_about_the_liver();
    constexpr int painting_tumours = 8;
    take(painting_tumours);
    scene().set_crosshair(ct_.grid.to_mm(20, 36, 30));
    QTest::keyClick(&axial(), Qt::Key_Return);
    ASSERT_EQ(scene().tumours().tumours().size(), 1u);
    EXPECT_EQ(window_.messages().text(), "") << "all of it is kept";
    const double before_ml = scene().tumours().tumours()[0].volume_ml;
    scene().set_crosshair(ct_.grid.to_mm(20, 44, 30));
    QTest::keyClick(&axial(), Qt::Key_Return);
    const QString notice = window_.messages().text();
    EXPECT_TRUE(notice.contains("left out")) << notice.toStdString();
    EXPECT_GT(scene().tumours().tumours()[0].volume_ml, before_ml) << "the other half";
    QTest::mouseClick(window_.messages().findChild<QPushButton*>("offer"), Qt::LeftButton);
    EXPECT_EQ(scene().tumours().tumours()[0].volume_ml, before_ml);
    EXPECT_TRUE(window_.log().as_text().contains("no longer so\tCorrections\tThis tumour reaches"))
        << window_.log().as_text().toStdString();
}

TEST(TumourIsCutOff, WhereTheCtGoesOnBeyondTheCanvas) {
    const Grid ct{{60, 30, 30}};
    const Grid canvas = crop(ct, IndexBox{{0, 0, 0}, {40, 30, 30}});
    const auto cut = [&](double x) {
        return tumour_is_cut_off({{Vec3(x, 15, 15)}, 4.0, false}, canvas, ct);
    };
    EXPECT_FALSE(cut(20.0));
    EXPECT_FALSE(cut(35.0)) << "its last voxel is the canvas's";
    EXPECT_TRUE(cut(36.0));
    EXPECT_TRUE(cut(50.0));
    EXPECT_FALSE(cut(1.0)) << "nothing is seen beyond the CT";
    EXPECT_TRUE(tumour_is_cut_off({{Vec3(5, 15, 15), Vec3(50, 15, 15)}, 1.0, false}, canvas, ct));
}

TEST(TumourLiesOutside, OfTheLiverWhereNeitherLiverNorAnotherTumourIsNear) {
    Grid grid{{60, 30, 30}};
    Mask organs(grid);
    const auto painted = [&](double x) {
        const BrushStroke stroke{{Vec3(x, 15, 15)}, 4.0, false};
        Mask with = organs;
        apply(stroke, organ_label::first_tumour, with);
        return tumour_lies_outside(stroke, with);
    };
    EXPECT_FALSE(painted(50.0)) << "no liver is known";
    for (int z = 0; z < 30; ++z)
        for (int y = 0; y < 30; ++y)
            for (int x = 0; x < 20; ++x) organs.at(x, y, z) = organ_label::liver;
    EXPECT_FALSE(painted(10.0));
    EXPECT_FALSE(painted(26.0)) << "it may stick out of the liver";
    EXPECT_TRUE(painted(40.0));
    apply({{Vec3(44, 15, 15)}, 4.0, false}, organ_label::first_tumour, organs);
    EXPECT_FALSE(painted(40.0)) << "it goes on with one that is there";
}

}  // namespace
}  // namespace hepatica
