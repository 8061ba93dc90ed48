// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/vessel_flow.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/flow/flow_shares.h"
#include "core/flow/fluid.h"
#include "tests/ui/fake_simulation.h"
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

TEST(InjectionCurves, follow_hagen_and_poiseuille_through_a_tube) {
    InjectDrug injection;
    injection.mass_flow_g_s = 0.5;
    Job job;
    const InjectionCurves curves = injection_curves(tube(), TreePoint{0, 0.0, 0.0}, injection, job);
    const Fluid fluid = pure(blood());
    const double pressure = 8.0 * fluid.viscosity_pa_s * 100.0 * 0.5 /
                            (std::numbers::pi * fluid.density_g_mm3 * std::pow(3.0, 4));
    const Curve& at_tip = curves.pressure.curves.at(0);
    for (const double value : at_tip.y) EXPECT_NEAR(value, pressure, 1e-6 * pressure);

    // Nothing comes out before the tube is full, then as much as goes in.
    const double full_s = std::numbers::pi * 9.0 * 100.0 * fluid.density_g_mm3 / 0.5;
    const Curve& out = curves.delivery.curves.at(0);
    EXPECT_GT(out.x.back(), full_s);
    for (std::size_t i = 0; i < out.x.size(); ++i) {
        const double expected = out.x[i] > full_s ? 100.0 * (out.x[i] - full_s) / out.x[i] : 0.0;
        EXPECT_NEAR(out.y[i], expected, 1e-6) << out.x[i];
    }
}

TEST(InjectionCurves, refuse_nonsense_and_can_be_cancelled) {
    InjectDrug injection;
    Job job;
    injection.pressure_model = "wishful";
    EXPECT_THROW(injection_curves(tube(), TreePoint{0, 0.0, 0.0}, injection, job), InputError);
    job.cancel();
    EXPECT_THROW(injection_curves(tube(), TreePoint{0, 0.0, 0.0}, {}, job), Cancelled);
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
