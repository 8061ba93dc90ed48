// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen is what is hit, on plain and on dense screens. ctest runs these once for each
// QT_SCALE_FACTOR; only the picture's own size tells here how many pixels a point has.
#include <QImage>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "tests/ui/fake_window_test.h"

namespace hepatica {
namespace {

class Scale : public testing::FakeWindowTest {
  protected:
    Scale() {
        window_.actions()[ActionId::toggle_panels].trigger();  // small screens have little room
        window_.resize(600, 460);
        open_built_in();
    }

    double pixels_per_point(const QImage& picture) {
        return static_cast<double>(picture.width()) / window_.view().width();
    }
    // Left and right end of the vessel in one row of the picture.
    struct Extent {
        int left = -1;
        int right = -1;
    };
    static Extent vessel_in_row(const QImage& picture, int row) {
        const QColor room = picture.pixelColor(0, row);  // the same along each row
        Extent extent;
        for (int x = 0; x < picture.width(); ++x) {
            const QColor colour = picture.pixelColor(x, row);
            const int difference = std::abs(colour.red() - room.red()) +
                                   std::abs(colour.green() - room.green()) +
                                   std::abs(colour.blue() - room.blue());
            if (difference < 12) continue;
            if (extent.left < 0) extent.left = x;
            extent.right = x;
        }
        return extent;
    }
    bool takes_hold_at(double x, double y, double ratio) {
        const std::size_t before = commands_of_type<GrabPoint>().size();
        const QPoint point = QPointF(x / ratio, y / ratio).toPoint();
        QTest::mousePress(&window_.view(), Qt::LeftButton, {}, point);
        QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, point);
        return commands_of_type<GrabPoint>().size() > before;
    }
};

TEST_F(Scale, is_the_one_asked_for) {
    const char* factor = std::getenv("QT_SCALE_FACTOR");
    EXPECT_DOUBLE_EQ(window_.view().devicePixelRatioF(), factor ? std::atof(factor) : 1.0);
    const QImage picture = window_.view().picture();
    EXPECT_NEAR(pixels_per_point(picture), window_.view().devicePixelRatioF(), 0.01);
}

TEST_F(Scale, the_mouse_takes_hold_exactly_of_what_is_drawn) {
    window_.actions()[ActionId::toggle_annotations].trigger();
    const QImage picture = window_.view().picture();
    const double ratio = pixels_per_point(picture);
    int rows = 0;
    for (int row = picture.height() * 5 / 8; row < picture.height() * 7 / 8; row += 23) {
        const Extent vessel = vessel_in_row(picture, row);
        if (vessel.left < 0) continue;
        ++rows;
        const double away = 2.0 * ratio;  // edges are smoothed, and points are whole
        EXPECT_TRUE(takes_hold_at(vessel.left + away, row, ratio)) << row;
        EXPECT_TRUE(takes_hold_at(vessel.right - away, row, ratio)) << row;
        EXPECT_FALSE(takes_hold_at(vessel.left - away, row, ratio)) << row;
        EXPECT_FALSE(takes_hold_at(vessel.right + away, row, ratio)) << row;
    }
    EXPECT_GE(rows, 4);
}

TEST_F(Scale, the_pulls_bead_is_drawn_under_the_mouse) {
    const QPoint start = on_trunk(), end = start + QPoint(60, -25);
    QTest::mousePress(&window_.view(), Qt::LeftButton, {}, start);
    QTest::mouseMove(&window_.view(), end);
    paint();
    const QImage picture = window_.view().picture();
    QPointF sum;
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const QColor colour = picture.pixelColor(x, y);
            const bool of_the_bead = colour.green() > 200 && colour.red() < 120;
            // The line leads here from the start; only the bead is on the far side of the mouse.
            // The legend's swatch of the pull is as green, far from it.
            const double ratio = pixels_per_point(picture);
            const bool near = std::abs(x - end.x() * ratio) < 20.0 * ratio &&
                              std::abs(y - end.y() * ratio) < 20.0 * ratio;
            if (!of_the_bead || !near || x < end.x() * ratio) continue;
            sum += QPointF(x + 0.5, y + 0.5);
            ++count;
        }
    QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, end);
    ASSERT_GT(count, 10);
    const QPointF centre = sum / count / pixels_per_point(picture);
    EXPECT_NEAR(centre.x(), end.x(), 3.0);  // half a disc of 4 points: its centre lies 1.7 beyond
    EXPECT_GT(centre.x(), end.x());
    EXPECT_NEAR(centre.y(), end.y(), 1.0);
}

}  // namespace
}  // namespace hepatica
