// SPDX-License-Identifier: GPL-3.0-or-later
// What a blade does to joints that are whole and to joints that have begun to tear.
#include <gtest/gtest.h>

#include "core/base/frame_time.h"
#include "core/deform/body/energy_ledger.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/tear/tearing.h"
#include "tests/tear/bars.h"

namespace hepatica {
namespace {

using test::bar;
using test::clamp_at_0;
using test::pull_of;

// Pulled at a notch until this many ties bind, and store this share of all energy; the last report.
StepReport pulled_until_bound(Stepper& stepper, const BodyDescription& body, std::size_t ties,
                              double share) {
    stepper.cut(Vec3(12.0, -1, -1), Vec3(0, 6, 0), Vec3(0, 0, 2.5));
    StepReport report;
    const auto bound = [&] {
        return stepper.tearing()->ties().size() >= ties &&
               report.energy.cohesion >= share * stored_energy(report.energy);
    };
    for (int k = 1; k < 400 && !bound(); ++k) {
        stepper.set_grabs(pull_of(body, 20.0, 0.2 * k));
        report = stepper.step(frame_s);
    }
    EXPECT_TRUE(bound());
    return report;
}

// Across the bar in the middle of what binds.
void cut_ties(Stepper& stepper) {
    const std::span<const SofteningTie> ties = stepper.tearing()->ties();
    double middle = 0.0;
    for (const SofteningTie& tie : ties)
        for (const int v : tie.vertices)
            middle += stepper.positions_mm()[v].x() / (2.0 * static_cast<double>(ties.size()));
    stepper.cut(Vec3(middle, -5, -5), Vec3(0, 14, 0), Vec3(0, 0, 14));
}

BodyDescription tough_bar() {
    BodyDescription body =
        bar(Vec3(20, 4, 4), {15, 3, 3}, {.strength_pa = 1e5, .fracture_energy_j_m2 = 300.0});
    clamp_at_0(body);
    return body;
}

// Joints that soften still bind the two sides, until a blade goes through them.
TEST(Blade, CutsWhatHasBegunToTear) {
    const BodyDescription body = tough_bar();
    const auto stepper = make_cpu_stepper(body, {});
    const StepReport report = pulled_until_bound(*stepper, body, 20, 0.0);
    const Tearing& tearing = *stepper->tearing();
    const std::size_t bound = tearing.ties().size();
    ASSERT_EQ(tearing.report().pieces, 1);
    cut_ties(*stepper);
    EXPECT_EQ(tearing.report().pieces, 2);
    EXPECT_LT(tearing.ties().size(), bound);
    stepper->set_grabs({});
    EXPECT_LE(stored_energy(stepper->step(frame_s).energy), stored_energy(report.energy));
}

// What ties have stored is gone with them, and booked as the blade's.
TEST(Blade, BooksWhatItTakesFromTiesAsItsWork) {
    const BodyDescription body = tough_bar();
    const auto stepper = make_cpu_stepper(body, {});
    const double stored = stored_energy(pulled_until_bound(*stepper, body, 20, 0.01).energy);
    cut_ties(*stepper);
    const EnergyLedger cut = stepper->energies();
    EXPECT_LT(cut.tool_work, -1e-3 * stored);
    EXPECT_NEAR(stored_energy(cut) - stored, cut.tool_work, 1e-9 * stored);
    const EnergyLedger after = stepper->step(frame_s).energy;
    EXPECT_NEAR(stored_energy(after) - stored, explained_change(after), 1e-9 * stored);
}

// Half of what the surface has grown by at rest, without what is parted but bound still.
TEST(TornArea, IsThatOfWhatNothingBindsAnyMore) {
    const BodyDescription body = tough_bar();
    const auto surface_mm2 = [&](const Stepper& stepper) {
        const TornTopology& topology = stepper.tearing()->topology();
        const auto rest = [&](int v) { return body.mesh.vertices_mm[topology.parents()[v]]; };
        double area = 0.0;
        for (const auto& t : topology.surface())
            area += 0.5 * (rest(t[1]) - rest(t[0])).cross(rest(t[2]) - rest(t[0])).norm();
        return area;
    };
    const auto pulled = make_cpu_stepper(body, {}), cut = make_cpu_stepper(body, {});
    const double whole = surface_mm2(*pulled);
    const TearReport& report = pulled->tearing()->report();
    for (int k = 1; k < 400 && report.joints_parted < 10; ++k) {
        pulled->set_grabs(pull_of(body, 20.0, 0.2 * k));
        pulled->step(frame_s);
    }
    ASSERT_GE(report.joints_parted, 10);
    ASSERT_GT(surface_mm2(*pulled), whole + 1.0);
    EXPECT_EQ(report.torn_area_mm2, 0.0) << "all that is parted is bound";
    cut->cut(Vec3(9.1, -5, -5), Vec3(0.3, 14, 0), Vec3(0, 0, 14));
    const double grown = surface_mm2(*cut) - whole;
    EXPECT_GT(grown, 2.0 * 16.0);
    EXPECT_NEAR(cut->tearing()->report().torn_area_mm2, 0.5 * grown, 1e-9 * grown);
}

}  // namespace
}  // namespace hepatica
