// SPDX-License-Identifier: GPL-3.0-or-later
// Measuring by clicks on the vessels in the three-dimensional view, with real mouse and keys.
#include "ui/view_ruler.h"

#include <QComboBox>
#include <QMenu>
#include <QStatusBar>
#include <QToolButton>
#include <cmath>
#include <numbers>

#include "core/tree/lumen_calibre.h"
#include "render/label_places.h"
#include "tests/ui/fake_window_test.h"
#include "tests/ui/speaks.h"
#include "ui/slices/view_layout.h"

namespace hepatica::testing {
namespace {

class Measuring : public FakeWindowTest {
  protected:
    Measuring() { open_built_in(); }

    Measurements& measurements() { return window_.view_layout().slices().measurements(); }
    const std::vector<MeasureView>& drawn() { return window_.view().scene().measures(); }
    // On the trunk's front, whose axis runs along z.
    void click_trunk_at(double height_mm) {
        QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(Vec3(0, 0, height_mm)));
    }
    QString said() { return window_.statusBar()->currentMessage(); }
    bool chosen(ActionId id) { return window_.actions()[id].isChecked(); }
};

TEST_F(Measuring, ADistanceIsThatOfTwoClicksOnVessels) {
    QTest::keyClick(&window_, Qt::Key_M);
    EXPECT_EQ(window_.view().mouse().mode(), MouseMode::measure);
    EXPECT_TRUE(chosen(ActionId::measure_distance));
    EXPECT_FALSE(chosen(ActionId::pull_mode));
    EXPECT_TRUE(said().contains("begins"));
    EXPECT_TRUE(said().contains("anywhere in a slice"));
    click_trunk_at(-50.0);
    ASSERT_NE(measurements().half_made(), nullptr);
    EXPECT_TRUE(said().contains("ends"));
    EXPECT_EQ(drawn().size(), 1u) << "its first point is seen";
    click_trunk_at(-25.0);
    ASSERT_EQ(measurements().made().size(), 1u);
    const Measurement& made = measurements().made()[0];
    // Two points of the trunk's front, as high as was clicked but for the mouse's whole pixels.
    EXPECT_NEAR((made.points_mm[1] - made.points_mm[0]).norm(), 25.0, 1.0);
    for (const Vec3& point : made.points_mm)
        EXPECT_NEAR(std::hypot(point.x(), point.y()), 5.5, 0.8) << "on the wall";
    EXPECT_EQ(said().toStdString(), made.text);
    ASSERT_EQ(drawn().size(), 1u);
    EXPECT_EQ(drawn()[0].text, made.text);
    EXPECT_EQ(drawn()[0].points_mm.size(), 2u);
    EXPECT_TRUE(commands_of_type<GrabPoint>().empty()) << "nothing was pulled";
}

TEST_F(Measuring, LightsAButtonOfTheToolBar) {
    const auto* button = window_.findChild<QToolButton*>("measureButton");
    ASSERT_NE(button, nullptr);
    EXPECT_TRUE(button->isVisible());
    EXPECT_FALSE(button->icon().isNull());
    EXPECT_FALSE(button->isChecked());
    for (const ActionId id : measuring_actions) {
        EXPECT_TRUE(button->menu()->actions().contains(&window_.actions()[id]));
        window_.actions()[id].trigger();
        EXPECT_TRUE(button->isChecked());
    }
    window_.actions()[ActionId::pull_mode].trigger();
    EXPECT_FALSE(button->isChecked());
}

TEST_F(Measuring, AnAngleIsThatOfThreeClicks) {
    QTest::keyClick(&window_, Qt::Key_M, Qt::ShiftModifier);
    EXPECT_TRUE(chosen(ActionId::measure_angle));
    for (const double height : {-50.0, -25.0, -45.0}) click_trunk_at(height);
    ASSERT_EQ(measurements().made().size(), 1u);
    const auto& points = measurements().made()[0].points_mm;
    const Vec3 a = points[0] - points[1], b = points[2] - points[1];
    const double degrees = std::acos(a.normalized().dot(b.normalized())) * 180.0 / std::numbers::pi;
    EXPECT_NEAR(degrees, 0.0, 5.0) << "along one straight vessel";
    EXPECT_EQ(measurements().made()[0].text,
              QString("%1\u00b0").arg(degrees, 0, 'f', 0).toStdString());
}

// The window is made in the language that is spoken then.
class GermanSpoken {
  private:
    Speaks speaks_{"de"};
};
class MeasuringInGerman : private GermanSpoken, public Measuring {};

TEST_F(MeasuringInGerman, EachClickIsAskedForInGerman) {
    QTest::keyClick(&window_, Qt::Key_M, Qt::ShiftModifier);
    EXPECT_TRUE(said().startsWith("Klicken Sie auf einen Schenkel")) << said().toStdString();
    click_trunk_at(-50.0);
    EXPECT_EQ(said(), "Klicken Sie auf seinen Scheitel");
    click_trunk_at(-25.0);
    EXPECT_EQ(said(), "Klicken Sie auf den anderen Schenkel");
}

TEST_F(Measuring, ADiameterIsThatAtTheCentreline) {
    QTest::keyClick(&window_, Qt::Key_M, Qt::ControlModifier);
    click_trunk_at(-37.5);  // half way: 5.5 mm of radius
    ASSERT_EQ(measurements().made().size(), 1u);
    const Measurement& made = measurements().made()[0];
    EXPECT_NEAR((made.points_mm[1] - made.points_mm[0]).norm(), 11.0, 0.1);
    EXPECT_LT((0.5 * (made.points_mm[0] + made.points_mm[1])).head<2>().norm(), 1e-9)
        << "about the axis";
    // Across the vessel, in the plane of the picture.
    const Vec3 along = (made.points_mm[1] - made.points_mm[0]).normalized();
    EXPECT_NEAR(std::abs(along.x()), 1.0, 1e-9);
    EXPECT_TRUE(QString::fromStdString(made.text).startsWith("\u2300 11.0 mm, stenosis 0 %"))
        << made.text;
}

// The trunk's end is 3 mm away.
TEST_F(Measuring, ADiameterNearAnEndSaysWhereAStenosisIsJudged) {
    QTest::keyClick(&window_, Qt::Key_M, Qt::ControlModifier);
    click_trunk_at(-57.0);
    ASSERT_EQ(measurements().made().size(), 1u);
    EXPECT_EQ(measurements().made()[0].text.find("stenosis"), std::string::npos);
    EXPECT_TRUE(said().contains("10 mm to both sides")) << said().toStdString();
}

TEST_F(Measuring, AClickBesideTheVesselsSaysSoAndADragTurnsTheView) {
    QTest::keyClick(&window_, Qt::Key_M);
    const QPoint beside = on_widget(Vec3(-60, 0, -60));
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, beside);
    EXPECT_TRUE(said().contains("No vessel there"));
    EXPECT_EQ(measurements().half_made(), nullptr);
    const Vec3 forward = window_.view().scene().axes().forward;
    QTest::mousePress(&window_.view(), Qt::LeftButton, {}, on_trunk());
    QTest::mouseMove(&window_.view(), on_trunk() + QPoint(60, 0));
    QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, on_trunk() + QPoint(60, 0));
    EXPECT_GT((window_.view().scene().axes().forward - forward).norm(), 0.1);
    EXPECT_EQ(measurements().half_made(), nullptr);
}

TEST_F(Measuring, EscapeEndsItAndTheMenuTakesTheLinesAway) {
    QTest::keyClick(&window_, Qt::Key_M, Qt::ControlModifier);
    click_trunk_at(-30.0);
    click_trunk_at(-40.0);
    QTest::keyClick(&window_, Qt::Key_M);
    click_trunk_at(-30.0);  // half made
    QTest::keyClick(&window_, Qt::Key_Escape);
    EXPECT_EQ(window_.view().mouse().mode(), MouseMode::pull);
    EXPECT_TRUE(chosen(ActionId::pull_mode));
    EXPECT_FALSE(measurements().chosen());
    EXPECT_EQ(measurements().half_made(), nullptr);
    EXPECT_EQ(drawn().size(), 2u);
    QTest::keyClick(&window_, Qt::Key_Delete, Qt::ShiftModifier);
    EXPECT_EQ(drawn().size(), 1u);
    QTest::keyClick(&window_, Qt::Key_Escape);
    EXPECT_EQ(drawn().size(), 1u) << "what was measured is work";
    window_.actions()[ActionId::clear_measurements].trigger();
    EXPECT_TRUE(measurements().made().empty());
    EXPECT_TRUE(drawn().empty());
}

// What is pulled keeps the value of its rest shape, and says so; its line goes along.
TEST_F(Measuring, HoldsForTheShapeAtRest) {
    QTest::keyClick(&window_, Qt::Key_M);
    click_trunk_at(-50.0);
    click_trunk_at(-30.0);
    QTest::keyClick(&window_, Qt::Key_Escape);
    const MeasureView before = drawn()[0];
    EXPECT_FALSE(QString::fromStdString(before.text).contains("rest"));
    QTest::mousePress(&window_.view(), Qt::LeftButton, {}, on_trunk());
    ASSERT_TRUE(wait_for([this] { return window_.frame().grab.has_value(); }));
    QTest::mouseMove(&window_.view(), on_trunk() + QPoint(60, 0));
    ASSERT_TRUE(
        wait_for([&] { return (drawn()[0].points_mm[0] - before.points_mm[0]).norm() > 3.0; }));
    EXPECT_EQ(drawn()[0].text, before.text + " (at rest)");
    // A click on the vessel where it is now measures where it was.
    QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, on_trunk() + QPoint(60, 0));
    QTest::keyClick(&window_, Qt::Key_M, Qt::ControlModifier);
    const Frame& frame = window_.frame();
    const auto& rest = window_.workspace().patient()->mesh.vertices_mm;
    std::size_t front = 0;  // a vertex that is seen and was moved
    for (std::size_t v = 0; v < rest.size(); ++v)
        if (rest[v].y() < -4.0 &&
            (rest[v] - Vec3(0, -5.5, -40)).norm() < (rest[front] - Vec3(0, -5.5, -40)).norm())
            front = v;
    const float* at = &frame.positions_mm[3 * front];
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(Vec3(at[0], at[1], at[2])));
    ASSERT_EQ(measurements().made().size(), 2u);
    const auto& points = measurements().made()[1].points_mm;
    EXPECT_LT((0.5 * (points[0] + points[1])).head<2>().norm(), 1e-9) << "about the axis at rest";
    EXPECT_TRUE(QString::fromStdString(drawn()[1].text).endsWith("(at rest)"));
}

// One choice and one list for the view and the slices; another mode of the mouse ends it.
TEST_F(Measuring, IsOneWithThatInTheSlices) {
    auto* choice = window_.findChild<QComboBox*>("measure");
    QTest::keyClick(&window_, Qt::Key_M, Qt::ShiftModifier);
    EXPECT_EQ(choice->currentText(), "Angle");
    emit choice->activated(3);
    EXPECT_TRUE(chosen(ActionId::measure_diameter));
    EXPECT_EQ(window_.view().mouse().mode(), MouseMode::measure);
    click_trunk_at(-40.0);
    EXPECT_EQ(measurements().made().size(), 1u);
    emit choice->activated(0);
    EXPECT_EQ(window_.view().mouse().mode(), MouseMode::pull);
    emit choice->activated(1);
    QTest::keyClick(&window_, Qt::Key_2);
    EXPECT_EQ(window_.view().mouse().mode(), MouseMode::inject);
    EXPECT_EQ(choice->currentText(), "Crosshair");
    EXPECT_FALSE(measurements().chosen());
    EXPECT_EQ(measurements().made().size(), 1u);
    open_built_in();
    EXPECT_TRUE(measurements().made().empty()) << "they were another patient's";
    EXPECT_TRUE(drawn().empty());
}

TEST_F(Measuring, LabelsOfMeasuresThatEndSideBySideLieOnNoOther) {
    for (const double begins : {-55.0, -50.0, -45.0}) {
        QTest::keyClick(&window_, Qt::Key_M);
        click_trunk_at(begins);
        click_trunk_at(-25.0);
    }
    ASSERT_EQ(drawn().size(), 3u);
    window_.view().drawn();
    const std::vector<PictureBox>& labels = window_.view().scene().measure_labels();
    ASSERT_EQ(labels.size(), 3u);
    for (std::size_t a = 0; a < labels.size(); ++a)
        for (std::size_t b = a + 1; b < labels.size(); ++b)
            EXPECT_FALSE(overlap(labels[a], labels[b])) << a << " on " << b;
}

using Corner = std::optional<std::array<double, 2>>;

Corner corner_of(const std::optional<PlacedLabel>& label) {
    return label ? Corner({label->box.left, label->box.top}) : std::nullopt;
}

TEST(LabelPlaces, ShiftByTheLeastThatIsFreeAndStayInThePicture) {
    LabelPlaces places({0, 0, 140, 100});
    EXPECT_EQ(corner_of(places.place({10, 40, 50, 20})), Corner({10, 40}));
    EXPECT_EQ(corner_of(places.place({80, 40, 50, 20})), Corner({80, 40})) << "beside it";
    EXPECT_EQ(corner_of(places.place({20, 45, 50, 20})), Corner({20, 62})) << "below it";
    EXPECT_EQ(corner_of(places.place({20, 35, 50, 20})), Corner({20, 18})) << "above it";
    EXPECT_EQ(corner_of(places.place({10, 95, 10, 12})), Corner({10, 88})) << "not below the room";
    EXPECT_EQ(corner_of(places.place({135, 88, 10, 12})), Corner({130, 88})) << "not right of it";
    EXPECT_FALSE(places.place({10, 2, 10, 101})) << "higher than the room";
    EXPECT_FALSE(places.place({10, 2, 141, 10})) << "wider than the room";
}

// In a small view a column is full before the view is.
TEST(LabelPlaces, StandBesideEachOtherWhereAColumnIsFull) {
    LabelPlaces places({0, 0, 102, 42});
    EXPECT_EQ(corner_of(places.place({52, 0, 50, 20})), Corner({52, 0}));
    EXPECT_EQ(corner_of(places.place({52, 0, 50, 20})), Corner({52, 22}));
    const auto beside = places.place({52, 0, 50, 20});
    EXPECT_EQ(corner_of(beside), Corner({0, 0}));
    EXPECT_TRUE(beside && beside->evades);
    EXPECT_EQ(corner_of(places.place({0, 20, 50, 20})), Corner({0, 22}));
    EXPECT_FALSE(places.place({0, 20, 50, 20})) << "the room is full";
}

// Without a window: three vertices, of which two are moved, each its own way.
TEST(ViewRuler, EachPointGoesAlongWithTheVertexThatIsNearestToIt) {
    auto patient = std::make_shared<PatientCase>();
    patient->mesh.vertices_mm = {Vec3(0, 0, 0), Vec3(40, 0, 0), Vec3(80, 0, 0)};
    Frame frame;
    frame.positions_mm = {0, 0, 0, 40, 5, 0, 80, 0, 7};
    Measurements measurements;
    std::vector<MeasureView> shown;
    ViewRuler ruler(measurements,
                    {[&](std::vector<MeasureView> views) { shown = std::move(views); },
                     [](const std::string&) {}, [&] { return &frame; }});
    ruler.show_patient(patient);
    measurements.choose(MeasurementKind::distance);
    const auto add = [&](const Vec3& point) { measurements.add_point(point, {}, patient->tree); };
    add(Vec3(1, 0, 0));
    add(Vec3(79, 0, 0));
    ASSERT_EQ(shown.size(), 1u);
    EXPECT_EQ(shown[0].points_mm, (std::vector{Vec3(1, 0, 0), Vec3(79, 0, 7)}));
    add(Vec3(41, 1, 0));
    add(Vec3(60, 0, 0));  // too far from all of them
    ASSERT_EQ(shown.size(), 2u);
    EXPECT_EQ(shown[1].points_mm, (std::vector{Vec3(41, 6, 0), Vec3(60, 0, 0)}));
    EXPECT_EQ(shown[1].text, measurements.made()[1].text + " (at rest)");
}

}  // namespace
}  // namespace hepatica::testing
