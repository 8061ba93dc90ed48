// SPDX-License-Identifier: GPL-3.0-or-later
// The mouse over a vessel: what lies downstream lights up and is told in words, for the very place
// under the mouse, and goes out again when the mouse leaves.
#include <QDockWidget>
#include <QLabel>
#include <QTableWidget>

#include "tests/ui/fake_window_test.h"
#include "ui/message_bar.h"

namespace hepatica {
namespace {

class Hover : public testing::FakeWindowTest {
  protected:
    Hover() { open_built_in(); }

    QString words() {
        for (const QLabel* label : window_.findChildren<QLabel*>())
            if (label->accessibleName() == "Under the mouse") return label->text();
        return "there is no such label";
    }
    void point_at_place(const QPoint& place) {
        QMouseEvent move(QEvent::MouseMove, place, window_.view().mapToGlobal(place), Qt::NoButton,
                         Qt::NoButton, Qt::NoModifier);
        QApplication::sendEvent(&window_.view(), &move);
    }
    void point_at_mm(const Vec3& place_mm) { point_at_place(on_widget(place_mm)); }

    // Mean red, green and blue of the view's picture around a point of the patient, of 255.
    Vec3 colour_at(const QImage& picture, const Vec3& place_mm) {
        const QPoint centre =
            on_widget(place_mm) * (static_cast<double>(picture.width()) / window_.view().width());
        Vec3 sum = Vec3::Zero();
        for (int y = -3; y <= 3; ++y)
            for (int x = -3; x <= 3; ++x) {
                const QRgb pixel = picture.pixel(centre + QPoint(x, y));
                sum += Vec3(qRed(pixel), qGreen(pixel), qBlue(pixel));
            }
        return sum / 49.0;
    }
    Vec3 colour_at(const Vec3& place_mm) { return colour_at(window_.view().picture(), place_mm); }
};

TEST_F(Hover, lights_up_what_lies_downstream_and_nothing_else) {
    const Vec3 upstream(0, 0, -55), downstream(0, 0, -22);
    point_at_place(QPoint(5, 5));
    const QImage dark = window_.view().picture();
    const QString nothing = words();
    point_at_mm(Vec3(0, 0, -40));
    const QImage lit = window_.view().picture();
    EXPECT_GT((colour_at(lit, downstream) - colour_at(dark, downstream)).norm(), 40.0);
    EXPECT_LT((colour_at(lit, upstream) - colour_at(dark, upstream)).norm(), 2.0);
    EXPECT_TRUE(window_.view().scene().legend().lit);
    EXPECT_FALSE(window_.view().scene().legend().lit_branch);
    EXPECT_TRUE(words().startsWith("Branch 1 ")) << words().toStdString();

    point_at_place(QPoint(5, 5));
    EXPECT_EQ(window_.view().picture(), dark);
    EXPECT_EQ(words(), nothing);
}

TEST_F(Hover, ends_when_the_mouse_leaves_the_view_or_takes_hold) {
    const QImage dark = window_.view().picture();
    const QString nothing = words();
    point_at_mm(Vec3(0, 0, -40));
    EXPECT_NE(words(), nothing);
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&window_.view(), &leave);
    EXPECT_EQ(words(), nothing);
    EXPECT_EQ(window_.view().picture(), dark);

    point_at_mm(Vec3(0, 0, -40));
    QTest::mousePress(&window_.view(), Qt::LeftButton, {}, on_trunk());
    EXPECT_EQ(words(), nothing);
    QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, on_trunk());
}

// The light begins where the mouse is, not where it came onto the branch.
TEST_F(Hover, follows_the_mouse_along_one_branch) {
    const Vec3 between(0, 0, -40);
    const Vec3 dark = colour_at(between);
    point_at_mm(Vec3(0, 0, -52));
    EXPECT_GT((colour_at(between) - dark).norm(), 40.0);
    const QString low = words();
    point_at_mm(Vec3(0, 0, -25));
    EXPECT_LT((colour_at(between) - dark).norm(), 2.0);
    const QString high = words();
    EXPECT_NE(low, high);
    // In millimetres from the branch's beginning, as near as vertices lie (3.2 mm apart).
    EXPECT_TRUE(low.contains("of 45 mm along")) << low.toStdString();
    const auto along_mm = [](const QString& text) {
        return text.section(", ", 1).section(' ', 0, 0).toDouble();
    };
    EXPECT_NEAR(along_mm(low), 8.0, 2.0) << low.toStdString();
    EXPECT_NEAR(along_mm(high), 35.0, 2.0) << high.toStdString();
}

// Whoever followed a warning to a branch still sees it after the mouse has passed over others.
TEST_F(Hover, gives_way_to_the_branch_that_was_chosen_in_the_table) {
    // Beside the centreline, where the line of a chosen branch lies.
    const Vec3 below(3, 0, -55), above(0, 0, -25);
    const Vec3 dark = colour_at(below);
    window_.messages().show_notice("Branch 1 is an end");
    emit window_.messages().findChild<QLabel*>()->linkActivated("branch:1");
    auto* table = window_.findChild<QTableWidget*>("branches");
    ASSERT_TRUE(testing::wait_for([table] { return table->currentRow() >= 0; }));
    paint();
    EXPECT_TRUE(window_.view().scene().legend().lit_branch);
    EXPECT_GT((colour_at(below) - dark).norm(), 40.0);
    point_at_mm(above);
    EXPECT_LT((colour_at(below) - dark).norm(), 2.0);
    point_at_place(QPoint(5, 5));
    EXPECT_GT((colour_at(below) - dark).norm(), 40.0);
    window_.findChild<QDockWidget*>("Branches")->hide();
    paint();
    point_at_mm(above);
    point_at_place(QPoint(5, 5));
    EXPECT_LT((colour_at(below) - dark).norm(), 2.0);
}

}  // namespace
}  // namespace hepatica
