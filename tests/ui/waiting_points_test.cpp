// SPDX-License-Identifier: GPL-3.0-or-later
// Points in the slices that wait for the vessel or the measurement that is to be made of them:
// undo takes back the last of them, and no correction that was made before.
#include <QComboBox>
#include <QLabel>
#include <QPushButton>

#include "tests/ui/slices_test.h"
#include "ui/message_bar.h"

namespace hepatica {
namespace {

constexpr int measuring_angle = 2, drawing = 4, painting = 6;  // in the list of what a click does

class WaitingPoints : public testing::SlicesTest {
  protected:
    // After a stroke of the brush, which a careless undo would take back.
    void begin(int purpose) {
        show_slices();
        take(painting);
        scene().set_crosshair(ct_.grid.to_mm(20, 25, 30));
        QTest::keyClick(&axial(), Qt::Key_Return);
        ASSERT_EQ(scene().brush().strokes().size(), 1u);
        take(purpose);
    }
    void take(int purpose) { emit window_.findChild<QComboBox*>("measure")->activated(purpose); }
    SliceView& axial() { return view(SliceDirection::axial); }
    void click(int x, int y) {
        QTest::mouseClick(&axial(), Qt::LeftButton, {}, axial().rect().center() + QPoint(x, y));
    }
    void undo() { QTest::keyClick(&axial(), Qt::Key_Z, Qt::ControlModifier); }
    void redo() { QTest::keyClick(&axial(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier); }
    QString name_of(ActionId id) { return window_.actions()[id].text().remove('&'); }
    // Two places that are too far apart to be drawn.
    void draw_in_vain() {
        SliceView& coronal = view(SliceDirection::coronal);
        click(8, 5);
        const Vec3 far_mm = scene().pen().places_mm()[0] - Vec3(0, 0, 60);
        QTest::mouseClick(&coronal, Qt::LeftButton, {}, coronal.place_of(far_mm).toPoint());
        QTest::keyClick(&coronal, Qt::Key_Return);
        ASSERT_TRUE(window_.messages().text().contains("more than 50 mm apart"));
    }
};

TEST_F(WaitingPoints, OfAVesselAreTakenBackBeforeAnyCorrection) {
    begin(drawing);
    for (const int x : {-20, 0, 20}) click(x, 8);
    ASSERT_EQ(scene().pen().places_mm().size(), 3u);
    EXPECT_EQ(name_of(ActionId::undo_edit), "Undo: Last point");
    for (const std::size_t left : {2u, 1u, 0u}) {
        undo();
        EXPECT_EQ(scene().pen().places_mm().size(), left);
        EXPECT_EQ(scene().brush().strokes().size(), 1u) << "it was made before";
    }
    EXPECT_TRUE(scene().pen().taken());
    EXPECT_TRUE(name_of(ActionId::undo_edit).startsWith("Undo: Vessels painted"));
    undo();
    EXPECT_TRUE(scene().brush().strokes().empty());
}

TEST_F(WaitingPoints, OfAMeasurementAreTakenBackBeforeAnyCorrection) {
    begin(measuring_angle);
    click(-20, 0);
    click(-20, 20);
    undo();
    ASSERT_NE(scene().measurements().half_made(), nullptr);
    EXPECT_EQ(scene().measurements().half_made()->points_mm.size(), 1u);
    undo();
    EXPECT_EQ(scene().measurements().half_made(), nullptr);
    EXPECT_EQ(scene().brush().strokes().size(), 1u);
    undo();
    EXPECT_TRUE(scene().brush().strokes().empty());
}

// What was undone before lies below the points: to do it again would be a surprise.
TEST_F(WaitingPoints, LetRedoWait) {
    begin(drawing);
    undo();
    ASSERT_TRUE(scene().brush().strokes().empty());
    click(0, 8);
    EXPECT_FALSE(window_.actions()[ActionId::redo_edit].isEnabled());
    redo();
    EXPECT_TRUE(scene().brush().strokes().empty());
    EXPECT_EQ(scene().pen().places_mm().size(), 1u);
    undo();
    redo();
    EXPECT_EQ(scene().brush().strokes().size(), 1u);
}

TEST_F(WaitingPoints, AreLeftAloneWhereTheyAreNotSeen) {
    begin(drawing);
    click(0, 8);
    window_.actions()[ActionId::toggle_slices].trigger();
    EXPECT_TRUE(name_of(ActionId::undo_edit).startsWith("Undo: Vessels painted"));
    window_.actions()[ActionId::undo_edit].trigger();
    EXPECT_TRUE(scene().brush().strokes().empty());
    EXPECT_EQ(scene().pen().places_mm().size(), 1u);
}

TEST_F(WaitingPoints, GiveWayToWhatWasCorrectedAfterThem) {
    begin(drawing);
    click(0, 8);
    window_.actions()[ActionId::edit_mode].trigger();
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_trunk());
    ASSERT_EQ(window_.workspace().edits().size(), 1u);
    ASSERT_EQ(scene().pen().places_mm().size(), 1u);
    EXPECT_NE(name_of(ActionId::undo_edit), "Undo: Last point");
    window_.actions()[ActionId::undo_edit].trigger();
    EXPECT_TRUE(window_.workspace().edits().empty());
    EXPECT_EQ(scene().pen().places_mm().size(), 1u);
}

TEST_F(WaitingPoints, TakeAlongWhyTheyWereNotDrawn) {
    begin(drawing);
    draw_in_vain();
    EXPECT_TRUE(window_.messages().text().contains(" mm left") ||
                window_.messages().text().contains(" mm right"))
        << window_.messages().text().toStdString();
    QTest::keyClick(&axial(), Qt::Key_Escape);
    ASSERT_TRUE(scene().pen().places_mm().empty());
    EXPECT_EQ(window_.messages().text(), "");
}

TEST_F(WaitingPoints, LeaveOtherMessagesAlone) {
    begin(drawing);
    draw_in_vain();
    window_.messages().show_notice("another word");
    QTest::keyClick(&axial(), Qt::Key_Escape);
    ASSERT_TRUE(scene().pen().places_mm().empty());
    EXPECT_EQ(window_.messages().text(), "another word");
}

}  // namespace
}  // namespace hepatica
