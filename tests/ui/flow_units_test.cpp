// SPDX-License-Identifier: GPL-3.0-or-later
// Flows and pressures in the units of the clinic: what is shown and typed, what is still injected,
// and that the choice is kept.
#include "ui/flow_units.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>

#include "core/flow/fluid.h"
#include "tests/ui/fake_window_test.h"
#include "ui/curves_dock.h"
#include "ui/elided_status_bar.h"
#include "ui/inject_panel.h"
#include "ui/plot_panel.h"
#include "ui/status_line.h"
#include "ui/tool_panel.h"

namespace hepatica {
namespace {

// A litre of water weighs a kilogram; blood 1.06 times as much.
TEST(FlowUnits, ConvertByTheDensityOfWhatFlows) {
    EXPECT_NEAR(ml_min_of(1.0, 1e-3), 60.0, 1e-12);
    EXPECT_NEAR(ml_min_of(1.06, 1.06e-3), 60.0, 1e-12);
    EXPECT_NEAR(g_s_of(60.0, 1.06e-3), 1.06, 1e-12);
    EXPECT_EQ(flow_units_named(name_of(FlowUnits::clinic)), FlowUnits::clinic);
    EXPECT_EQ(flow_units_named(name_of(FlowUnits::computed)), FlowUnits::computed);
    EXPECT_EQ(flow_units_named(""), FlowUnits::computed) << "as it was before there was a choice";
}

// 760 mmHg are an atmosphere, 101325 Pa.
TEST(FlowUnits, OfPressuresInAChart) {
    const Chart atmosphere{"Air", "Time (s)", "Pressure (Pa)", {{"here", {0.0}, {101325.0}}}};
    const Chart clinic = in_units(atmosphere, FlowUnits::clinic);
    EXPECT_EQ(clinic.y_label, "Pressure (mmHg)");
    EXPECT_NEAR(clinic.curves[0].y[0], 760.0, 1e-3);
    EXPECT_EQ(clinic.curves[0].x[0], 0.0);
    EXPECT_EQ(in_units(atmosphere, FlowUnits::computed).curves[0].y[0], 101325.0);
    const Chart share{"Drug", "Time (s)", "Delivered (%)", {{"here", {0.0}, {50.0}}}};
    EXPECT_EQ(in_units(share, FlowUnits::clinic).curves[0].y[0], 50.0) << "no pressure";
}

TEST(FlowUnits, OfTheCurvesFollowTheChoiceAtOnceAndBack) {
    PlotPanel plots;
    plots.set_units(FlowUnits::clinic);
    EXPECT_TRUE(plots.left().y_label.ends_with("(mmHg)")) << "also while they are empty";
    plots.set_charts({"", "Time (s)", "Pressure (Pa)", {{"p", {0.0, 1.0}, {0.0, 101325.0}}}},
                     {"", "Time (s)", "Delivered (%)", {{"d", {0.0, 1.0}, {0.0, 50.0}}}});
    EXPECT_NEAR(plots.left().curves[0].y[1], 760.0, 1e-3);
    EXPECT_EQ(plots.right().curves[0].y[1], 50.0);
    plots.set_units(FlowUnits::computed);
    EXPECT_EQ(plots.left().curves[0].y[1], 101325.0);
    EXPECT_EQ(plots.left().y_label, "Pressure (Pa)");
}

// 2.12 g/s are 120 mL/min of blood, and 530 g are half a litre.
TEST(FlowUnits, OfBleeding) {
    ToolPanel panel({});
    TearView tear;
    tear.joints_broken = 3;
    tear.leak_g_s = 2000.0 * blood().density_g_mm3;
    tear.leaked_g = 500e3 * blood().density_g_mm3;
    panel.show_tear(tear);
    const auto says = [&](const QString& text) {
        for (const QLabel* label : panel.findChildren<QLabel*>())
            if (label->text().contains(text)) return true;
        return false;
    };
    EXPECT_TRUE(says("bleeds 2.1 g/s, 530 g so far"));
    EXPECT_TRUE(says("cut or torn: joints of the mesh broken: 3")) << "of one cut, too";
    panel.set_units(FlowUnits::clinic);
    EXPECT_TRUE(says("bleeds 120 mL/min, 500 mL so far")) << "without another frame";
    panel.set_units(FlowUnits::computed);
    EXPECT_TRUE(says("bleeds 2.1 g/s, 530 g so far"));
    EXPECT_FALSE(says("of it up to")) << "no drug has leaked";
    tear.leaked_drug_g = 10e3 * blood().density_g_mm3;
    panel.show_tear(tear);
    EXPECT_TRUE(says("530 g so far, of it up to 10.6 g drug"));
    panel.set_units(FlowUnits::clinic);
    EXPECT_TRUE(says("500 mL so far, of it up to 10.0 mL (10.6 g) drug"));
}

class FlowUnitsInWindow : public testing::FakeWindowTest {
  protected:
    static void choose(MainWindow& window, int index) {
        auto& units = *window.findChild<QComboBox*>("flowUnits");
        units.setFocus();
        QTest::keyClick(&units, index == 0 ? Qt::Key_Home : Qt::Key_End);
    }
    static QDoubleSpinBox& flow(MainWindow& window) {
        return *window.findChild<QDoubleSpinBox*>("flow");
    }
    static bool says(MainWindow& window, const QString& text) {
        for (const QLabel* label : window.findChildren<QLabel*>())
            if (!label->isHidden() && label->text().contains(text)) return true;
        return false;
    }
    static InjectDrug injection(MainWindow& window) {
        auto* choice = window.findChild<QComboBox*>("flowUnits");
        return static_cast<InjectPanel*>(choice->parentWidget())->injection_at(Vec3(1, 2, 3));
    }
};

TEST_F(FlowUnitsInWindow, AreThoseOfBeforeUntilOthersAreChosen) {
    EXPECT_EQ(flow(window_).suffix(), " g/s");
    EXPECT_EQ(settings_.flow_units(), "");
    EXPECT_TRUE(static_cast<CurvesDock*>(window_.findChild<QDockWidget*>("Curves"))
                    ->plots()
                    .left()
                    .y_label.ends_with("(Pa)"));
}

TEST_F(FlowUnitsInWindow, ShowTheSameInjectionInOtherNumbers) {
    const double before = injection(window_).mass_flow_g_s;
    const double density = mixture(blood(), carrier(), 0.0).density_g_mm3;
    choose(window_, 1);
    EXPECT_EQ(flow(window_).suffix(), " mL/min");
    EXPECT_NEAR(flow(window_).value(), before / density * 60.0 / 1000.0, 0.005);
    EXPECT_NEAR(injection(window_).mass_flow_g_s, before, 1e-3);
    flow(window_).setValue(60.0);
    EXPECT_NEAR(injection(window_).mass_flow_g_s, 1000.0 * density, 1e-9)
        << "a millilitre a second";
    EXPECT_TRUE(says(window_, "That is 1.06 g/s of the drug")) << "doses are counted in grams";
    choose(window_, 0);
    EXPECT_FALSE(says(window_, "That is")) << "the field says it";
    EXPECT_EQ(flow(window_).suffix(), " g/s");
    EXPECT_NEAR(flow(window_).value(), 1000.0 * density, 1e-3);
}

// A pump set to a volume gives less mass of what is lighter.
TEST_F(FlowUnitsInWindow, KeepTheVolumeWhateverIsInjected) {
    choose(window_, 1);
    flow(window_).setValue(60.0);
    const double of_carrier = injection(window_).mass_flow_g_s;
    for (QComboBox* box : window_.findChildren<QComboBox*>())
        if (const int gas_preset = box->findText("Gas, as in the paper"); gas_preset >= 0)
            box->setCurrentIndex(gas_preset);
    EXPECT_EQ(flow(window_).value(), 60.0);
    const InjectDrug gas_now = injection(window_);
    EXPECT_EQ(gas_now.second_phase, "gas");
    EXPECT_NEAR(gas_now.mass_flow_g_s,
                1000.0 * mixture(blood(), gas(), gas_now.void_fraction).density_g_mm3, 1e-9);
    EXPECT_LT(gas_now.mass_flow_g_s, 0.7 * of_carrier);
    EXPECT_TRUE(says(window_, QString("That is %1 g/s").arg(gas_now.mass_flow_g_s, 0, 'g', 3)));
}

TEST_F(FlowUnitsInWindow, AreChosenInTheMenuToo) {
    auto& clinic = *window_.findChild<QAction*>("units_" + name_of(FlowUnits::clinic));
    auto& computed = *window_.findChild<QAction*>("units_" + name_of(FlowUnits::computed));
    auto* menu = static_cast<QMenu*>(clinic.associatedObjects().at(0));
    EXPECT_EQ(menu->title(), "U&nits");
    emit menu->aboutToShow();
    EXPECT_TRUE(computed.isChecked());
    clinic.trigger();
    EXPECT_EQ(flow(window_).suffix(), " mL/min");
    EXPECT_EQ(window_.findChild<QComboBox*>("flowUnits")->currentIndex(), 1);
    EXPECT_EQ(settings_.flow_units(), name_of(FlowUnits::clinic));
    choose(window_, 0);
    emit menu->aboutToShow();
    EXPECT_TRUE(computed.isChecked());
    EXPECT_FALSE(clinic.isChecked());
}

TEST_F(FlowUnitsInWindow, AreKeptForTheNextStart) {
    choose(window_, 1);
    EXPECT_EQ(settings_.flow_units(), name_of(FlowUnits::clinic));
    ASSERT_TRUE(window_.close());
    MainWindow next(settings_, {}, answers());
    EXPECT_EQ(flow(next).suffix(), " mL/min");
    EXPECT_EQ(next.findChild<QComboBox*>("flowUnits")->currentIndex(), 1);
    EXPECT_TRUE(static_cast<CurvesDock*>(next.findChild<QDockWidget*>("Curves"))
                    ->plots()
                    .left()
                    .y_label.ends_with("(mmHg)"));
    EXPECT_NEAR(injection(next).mass_flow_g_s, injection(window_).mass_flow_g_s, 1e-3);
}

// A lesson counts the area of what has parted, so the panel may not say that nothing has.
TEST(ToolPanel, SaysThatATearHasBegun) {
    ToolPanel panel({});
    const auto says = [&](const QString& text) {
        for (const QLabel* label : panel.findChildren<QLabel*>())
            if (label->text() == text) return true;
        return false;
    };
    TearView tear;
    panel.show_tear(tear);
    EXPECT_TRUE(says("nothing cut or torn"));
    tear.origins = std::make_shared<const std::vector<int>>(std::vector{0, 1, 2});
    panel.show_tear(tear);
    EXPECT_TRUE(says("nothing cut or torn")) << "it was made whole again";
    tear.origins = std::make_shared<const std::vector<int>>(std::vector{0, 1, 2, 1});
    panel.show_tear(tear);
    EXPECT_FALSE(says("nothing cut or torn"));
    EXPECT_TRUE(says("begun to tear, nothing is apart yet"));
}

TEST(ToolPanel, SaysHowALineIsDrawnWhileOneIs) {
    ToolPanel panel({});
    const auto help = [&] {
        QStringList texts;
        for (const QLabel* label : panel.findChildren<QLabel*>("quiet")) texts << label->text();
        return texts.join("\n");
    };
    EXPECT_TRUE(help().contains("Take a tool from the bar"));
    panel.show_kind({}, "Draw a line");
    EXPECT_FALSE(help().contains("Take a tool from the bar"));
    EXPECT_TRUE(help().contains("Draw a line"));
}

TEST(ToolPanel, SaysLittleBloodToTheTenthOfAGramAsALessonDoes) {
    ToolPanel panel({});
    TearView tear;
    tear.joints_broken = 3;
    tear.leak_g_s = 6.7;
    tear.leaked_g = 0.12;
    panel.show_tear(tear);
    bool said = false;
    for (const QLabel* label : panel.findChildren<QLabel*>())
        said = said || label->text().contains("bleeds 6.7 g/s, 0.1 g so far");
    EXPECT_TRUE(said);
}

// The panel that says so may be folded or below another one.
TEST(StatusLine, SaysWhatIsLostWhileItBleeds) {
    ElidedStatusBar bar;
    StatusLine line(bar);
    const auto* label = bar.findChild<QLabel*>("bleeding");
    TearView tear;
    line.show_bleeding(tear, FlowUnits::computed);
    EXPECT_TRUE(label->isHidden());
    tear.leak_g_s = 2.12;
    line.show_bleeding(tear, FlowUnits::computed);
    EXPECT_FALSE(label->isHidden());
    EXPECT_TRUE(label->text().endsWith("bleeds 2.1 g/s")) << label->text().toStdString();
    line.show_bleeding(tear, FlowUnits::clinic);
    EXPECT_TRUE(label->text().endsWith("bleeds 120 mL/min")) << label->text().toStdString();
    line.show_bleeding(std::nullopt, FlowUnits::clinic);
    EXPECT_TRUE(label->isHidden());
    line.show_bleeding(tear, FlowUnits::clinic);
    line.clear_statistics();
    EXPECT_TRUE(label->isHidden()) << "no patient is shown";
}

// Whoever holds another vessel than the one that bleeds must not read it as success.
TEST(ToolPanel, SaysWhetherWhatIsPressedFeedsTheBleeding) {
    ToolPanel panel({});
    const auto says = [&](const QString& text) {
        return panel.findChild<QLabel*>("torn")->text().contains(text);
    };
    TearView tear;
    tear.joints_broken = 3;
    tear.leak_g_s = 6.7;
    panel.show_tear(tear);
    EXPECT_FALSE(says("pressed"));
    tear.other_open_share = 0.011;
    tear.other_segment = 12;
    panel.show_tear(tear);
    EXPECT_TRUE(says("; branch 12, which does not feed the bleeding, is pressed to 1.1 % of"));
    EXPECT_FALSE(says("what feeds the bleeding is pressed"));
    tear.open_share = 0.5;
    panel.show_tear(tear);
    EXPECT_TRUE(says("; what feeds the bleeding is pressed to 50 % of its lumen; branch 12"));
    tear.other_open_share = 1.0;
    panel.show_tear(tear);
    EXPECT_FALSE(says("branch"));
}

// "whole" alone says nothing of what it is that is whole.
TEST(ToolPanel, SaysThatNothingIsTornWhereNothingCanTear) {
    ToolPanel panel({});
    panel.show_tear(std::nullopt);
    EXPECT_EQ(panel.findChild<QLabel*>("torn")->text(), "nothing cut or torn");
}

}  // namespace
}  // namespace hepatica
