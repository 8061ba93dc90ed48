// SPDX-License-Identifier: GPL-3.0-or-later
// Which part of a slice a view shows, and where the values of measurements stand in it.
#include "tests/ui/slices_test.h"

namespace hepatica {
namespace {

class SlicePlace : public testing::SlicesTest {};

TEST_F(SlicePlace, IsTheWholeOfAnotherCt) {
    show_slices();
    SliceView& axial = view(SliceDirection::axial);
    const Vec3 corner = axial.to_mm(QPointF(0, 0));
    turn_wheel(axial, 8, Qt::ControlModifier);
    const QPointF zoomed = axial.place_of(corner);
    EXPECT_LT(zoomed.x(), -10.0);
    scene().show_tree(patient_->tree);
    EXPECT_EQ(axial.place_of(corner), zoomed) << "a correction leaves it so";
    scene().show(std::make_shared<const Volume>(ct_), {}, patient_->tree);
    EXPECT_NEAR(axial.place_of(corner).x(), 0.0, 1e-9);
    EXPECT_NEAR(axial.place_of(corner).y(), 0.0, 1e-9);
}

// At the edge of a view, and several that end at one place.
TEST_F(SlicePlace, OfValuesOfMeasurementsIsWithinTheViewAndOnNoOther) {
    show_slices();
    SliceView& axial = view(SliceDirection::axial);
    scene().measurements().choose(MeasurementKind::distance);
    constexpr std::size_t count = 5;
    for (std::size_t m = 0; m < count; ++m)
        for (const double x : {10.0 + static_cast<double>(m), axial.width() - 2.0})
            scene().measurements().add_point(axial.to_mm({x, 0.5 * axial.height()}), {},
                                             scene().tree());
    ASSERT_EQ(scene().measurements().made().size(), count);
    axial.grab();
    const std::vector<QRectF>& labels = axial.measure_labels();
    ASSERT_EQ(labels.size(), count);
    for (std::size_t a = 0; a < labels.size(); ++a) {
        EXPECT_TRUE(QRectF(axial.rect()).contains(labels[a]));
        for (std::size_t b = a + 1; b < labels.size(); ++b)
            EXPECT_FALSE(labels[a].intersects(labels[b])) << a << " on " << b;
    }
}

}  // namespace
}  // namespace hepatica
