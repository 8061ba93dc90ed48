// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing a vessel that the tree lacks, by clicks in the slices.
#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>

#include "core/lesson/lesson_draft.h"
#include "core/lesson/lesson_writer.h"
#include "tests/support/tube_ct.h"
#include "tests/ui/editing_window.h"
#include "ui/lesson_dock.h"
#include "ui/paths.h"
#include "ui/slices/slice_view.h"
#include "ui/slices/view_layout.h"

namespace hepatica {
namespace {

class DrawingVessels : public testing::EditingWindow {};

// A vessel that the tree lacks, bright in the CT, from the trunk of the tree of test_trees.h.
TEST_F(DrawingVessels, a_vessel_is_drawn_by_clicks_in_the_slices) {
    const Vec3 begin = test::tube_begin_mm, end = test::tube_end_mm;
    point_out_the_tube();
    ViewLayout& views = window_.view_layout();
    SliceView& axial = views.slice_view(SliceDirection::axial);
    const std::size_t before = saved().tree.segments.size();
    // It is followed beside the window; until then its places stay, and Escape stops it.
    const VesselPen& pen = views.slices().pen();
    SliceView& coronal = views.slice_view(SliceDirection::coronal);
    coronal.setFocus();
    QTest::mouseClick(&child<QPushButton>("drawVessel"), Qt::LeftButton);
    EXPECT_EQ(window_.focusWidget(), &coronal) << "the keys stay those of the slice";
    EXPECT_TRUE(pen.draws());
    QTest::mouseClick(&axial, Qt::LeftButton, {}, axial.place_of(begin).toPoint());
    QTest::keyClick(&axial, Qt::Key_Delete);
    EXPECT_EQ(pen.places_mm().size(), 3u);
    QTest::keyClick(&axial, Qt::Key_Escape);
    EXPECT_FALSE(pen.draws());
    EXPECT_EQ(pen.places_mm().size(), 3u);
    EXPECT_TRUE(child<QLabel>("slicePlace").text().startsWith("Not drawn: it was stopped"));
    child<QPushButton>("drawVessel").click();
    ASSERT_TRUE(testing::wait_for([&] { return !pen.draws(); }));
    EXPECT_FALSE(child<QLabel>("slicePlace").text().contains("apart from all others"));
    ASSERT_EQ(saved().corrections.edits.size(), 1u);
    EXPECT_EQ(saved_.corrections.edits[0].kind, TreeEditKind::draw_vessel);
    EXPECT_EQ(saved_.tree.segments.size(), before + 2);  // the trunk has a fork more
    EXPECT_LT(nearest_point(saved_.tree, end).distance_mm, 0.6);
    EXPECT_TRUE(views.slices().pen().places_mm().empty());
    window_.actions()[ActionId::undo_edit].trigger();
    wait();
    EXPECT_TRUE(saved().corrections.edits.empty());
    EXPECT_EQ(saved_.tree.segments.size(), before);
}

// No blood would reach it.
TEST_F(DrawingVessels, a_vessel_that_is_drawn_apart_from_all_others_is_told_of) {
    point_out_the_tube(0.5);
    child<QPushButton>("drawVessel").click();
    const VesselPen& pen = window_.view_layout().slices().pen();
    ASSERT_TRUE(testing::wait_for([&] { return !pen.draws(); }));
    EXPECT_TRUE(child<QLabel>("slicePlace").text().contains("apart from all others"))
        << child<QLabel>("slicePlace").text().toStdString();
}

TEST_F(DrawingVessels, a_vessel_is_drawn_as_wide_as_its_field_says) {
    auto& radius = child<QDoubleSpinBox>("vesselRadius");
    EXPECT_TRUE(radius.isHidden());
    point_out_the_tube();  // 1.8 mm wide
    EXPECT_FALSE(radius.isHidden());
    EXPECT_EQ(radius.text(), "measured");
    radius.setValue(1.2);
    child<QPushButton>("drawVessel").click();
    const VesselPen& pen = window_.view_layout().slices().pen();
    ASSERT_TRUE(testing::wait_for([&] { return !pen.draws(); }));
    ASSERT_EQ(saved().corrections.edits.size(), 1u);
    const std::vector<double>& radii_mm = saved_.corrections.edits[0].radii_mm;
    EXPECT_EQ(radii_mm, std::vector<double>(radii_mm.size(), 1.2));
    EXPECT_EQ(pen.radius_mm(), 1.2) << "kept for the next one";
    radius.setValue(radius.minimum());
    EXPECT_EQ(pen.radius_mm(), std::nullopt);
}

// It would come in the middle of the lesson and be refused, and its places be gone.
TEST_F(DrawingVessels, a_vessel_is_not_drawn_on_when_a_lesson_begins) {
    point_out_the_tube();
    child<QPushButton>("drawVessel").click();
    write_lesson(to_path(folder_.filePath("any.json")), new_lesson());
    window_.lessons().start(folder_.filePath("any.json").toStdString());
    ASSERT_TRUE(testing::wait_for([&] { return window_.lessons().playing(); }));
    EXPECT_FALSE(window_.view_layout().slices().pen().draws());
    EXPECT_EQ(window_.view_layout().slices().pen().places_mm().size(), 3u);
}

}  // namespace
}  // namespace hepatica
