// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/vessel_flow.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/flow/flow_shares.h"
#include "core/flow/fluid.h"
#include "core/session/session.h"
#include "tests/session/small_patient.h"
#include "tests/ui/fake_simulation.h"
#include "tests/ui/window_test.h"
#include "ui/curves_dock.h"
#include "ui/paths.h"
#include "ui/plot_panel.h"

namespace hepatica {
namespace {

// One straight vessel of 3 mm radius and 100 mm length.
VesselTree tube() {
    VesselTree tree;
    tree.nodes = {{Vec3(0, 0, 0), 3.0}, {Vec3(0, 0, 100), 3.0}};
    VesselSegment segment;
    segment.proximal_node = 0;
    segment.distal_node = 1;
    segment.points_mm = {Vec3(0, 0, 0), Vec3(0, 0, 50), Vec3(0, 0, 100)};
    segment.radii_mm = {3.0, 3.0, 3.0};
    tree.segments = {segment};
    return tree;
}

TEST(FlowShares, equal_branches_share_equally) {
    const LoadedPatient patient = testing::fake_patient();
    const std::vector<double> shares = flow_shares(patient.patient->tree);
    ASSERT_EQ(shares.size(), 3u);
    EXPECT_NEAR(shares[0], 1.0, 1e-12);
    EXPECT_NEAR(shares[1], 0.5, 1e-9);
    EXPECT_NEAR(shares[2], 0.5, 1e-9);
    EXPECT_TRUE(flow_shares(VesselTree{}).empty());
}

InjectionOptions into_the_tube(double mass_flow_g_s) {
    InjectionOptions injection;
    injection.tip = TreePoint{0, 0.0, 0.0};
    injection.wedged = false;
    injection.mass_flow_g_s = mass_flow_g_s;
    return injection;
}

TEST(InjectionCurves, follow_hagen_and_poiseuille_through_a_tube) {
    const Fluid fluid = pure(blood());
    const double full_s = std::numbers::pi * 9.0 * 100.0 * fluid.density_g_mm3 / 0.5;
    Job job;
    const InjectionCurves curves = injection_curves(tube(), into_the_tube(0.5), 1.5 * full_s, job);
    const double pressure = 8.0 * fluid.viscosity_pa_s * 100.0 * 0.5 /
                            (std::numbers::pi * fluid.density_g_mm3 * std::pow(3.0, 4));
    const Curve& at_tip = curves.pressure.curves.at(0);
    for (const double value : at_tip.y) EXPECT_NEAR(value, pressure, 1e-6 * pressure);

    // Nothing comes out before the tube is full, then as much as goes in.
    const Curve& out = curves.delivery.curves.at(0);
    EXPECT_DOUBLE_EQ(out.x.back(), 1.5 * full_s);
    EXPECT_GT(out.x.size(), 100u);
    for (std::size_t i = 0; i < out.x.size(); ++i) {
        const double expected = out.x[i] > full_s ? 100.0 * (out.x[i] - full_s) / out.x[i] : 0.0;
        EXPECT_NEAR(out.y[i], expected, 1e-6) << out.x[i];
    }
}

TEST(InjectionCurves, refuse_nonsense_and_can_be_cancelled) {
    Job job;
    EXPECT_THROW(injection_curves(tube(), into_the_tube(-1.0), 1.0, job), InputError);
    job.cancel();
    EXPECT_THROW(injection_curves(tube(), into_the_tube(1.0), 1.0, job), Cancelled);
}

// What the session injects is what is plotted: a click near the end of the root goes to the place
// where the system is supplied, and the curves end with the drug's clock.
TEST(InjectionCurves, are_those_of_the_injection_that_the_session_shows) {
    const std::shared_ptr<const PatientCase> patient = test::small_patient();
    const VesselSegment& root = patient->tree.segments.front();
    ASSERT_LT(root.parent, 0);
    Job job;
    Session session(patient, default_scene(), job);
    InjectDrug command;
    command.point_mm =
        root.points_mm.front() +
        0.5 * root.radii_mm.front() * (root.points_mm[1] - root.points_mm[0]).normalized();
    command.second_phase = "lipiodol";
    command.void_fraction = 0.5;
    session.post(command);
    session.post(FinishInjection{});
    session.step();
    ASSERT_TRUE(session.update_frame());
    const DrugView& drug = session.frame().drug;
    ASSERT_TRUE(drug.injection);
    EXPECT_EQ(drug.injection->tip->segment, 0);
    EXPECT_EQ(drug.injection->tip->arclength_mm, 0.0) << "not where the system is supplied";

    const InjectionCurves curves =
        injection_curves(patient->tree, *drug.injection, drug.end_s, job);
    // The same from the command's own words.
    InjectionOptions options;
    options.tip = TreePoint{0, 0.0, 0.0};
    options.wedged = false;
    options.mass_flow_g_s = command.mass_flow_g_s;
    options.law = pressure_law(command.pressure_model);
    options.second_phase = lipiodol();
    options.void_fraction = 0.5;
    options.until_s = drug.end_s;
    const InjectionResult run = inject(patient->tree, options, job);
    const Curve& pressure = curves.pressure.curves.at(0);
    EXPECT_DOUBLE_EQ(pressure.x.back(), drug.end_s);
    EXPECT_NEAR(pressure.y.front(), run.series.front().inlet_pressure_pa,
                1e-9 * pressure.y.front());
    EXPECT_NEAR(pressure.y.back(), run.series.back().inlet_pressure_pa, 1e-3 * pressure.y.front());
    EXPECT_NE(pressure.y.back(), pressure.y.front()) << "oil is more viscous than blood";
    const InjectionSample& last = run.series.back();
    EXPECT_NEAR(curves.delivery.curves.at(0).y.back(), 100.0 * last.delivered_g / last.injected_g,
                0.1);

    session.post(RemoveDrug{});
    session.step();
    ASSERT_TRUE(session.update_frame());
    EXPECT_FALSE(session.frame().drug.injection);
}

// The dock's are of one injection; where it replaced others they say which.
TEST(InjectionCurves, of_several_injections_are_said_to_be_of_the_last) {
    auto patient = std::make_shared<PatientCase>();
    patient->tree = tube();
    CurvesDock dock([](const Failure& failure) { ADD_FAILURE() << failure.problem; }, nullptr);
    const PlotPanel& plots = dock.plots();
    DrugView drug;
    drug.end_s = 2.0;
    const auto pressure_of = [&](double mass_flow_g_s) {
        drug.injection = std::make_shared<const InjectionOptions>(into_the_tube(mass_flow_g_s));
        const double before = plots.left().curves.empty() ? 0.0 : plots.left().curves[0].y.front();
        dock.follow(patient, drug, false);
        EXPECT_TRUE(testing::wait_for([&] {
            return !plots.left().curves.empty() && plots.left().curves[0].y.front() != before;
        }));
        EXPECT_EQ(plots.left().x_label, plots.right().x_label);
        return plots.left().x_label;
    };
    ++drug.injections;
    EXPECT_EQ(pressure_of(0.5), "Time (s)");
    EXPECT_EQ(pressure_of(0.6), "Time (s)") << "the same, computed again as vessels tore";
    ++drug.injections;
    EXPECT_EQ(pressure_of(0.7), "Time since the last injection began (s)");
    dock.clear();
    EXPECT_EQ(pressure_of(0.5), "Time (s)") << "another patient's first";
}

TEST(AxisTicks, are_round_few_and_reach_the_end) {
    for (double largest = 3e-7; largest < 1e7; largest *= 1.7) {
        const std::vector<double> ticks = axis_ticks(largest);
        EXPECT_GE(ticks.back(), largest * (1 - 1e-9));
        EXPECT_LE(ticks.size(), 7u);
        EXPECT_GE(ticks.size(), 3u);
    }
}

TEST(PlotPanel, saves_picture_and_table) {
    QTemporaryDir folder;
    PlotPanel panel;
    panel.resize(900, 220);
    const Chart chart{"Pressure", "Time (s)", "Pressure (Pa)", {{"a", {0, 1, 2}, {5, 6, 3}}}};
    panel.set_charts(chart, chart);
    panel.show();
    panel.save_picture(folder.filePath("kurven_ä.png"));
    EXPECT_GT(QImage(folder.filePath("kurven_ä.png")).width(), 900);
    panel.save_table(folder.filePath("t.csv"));
    QFile file(folder.filePath("t.csv"));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_EQ(file.readAll().count('\n'), 8);
    EXPECT_THROW(panel.save_table("/proc/hepatica/t.csv"), InputError);
}

}  // namespace
}  // namespace hepatica
