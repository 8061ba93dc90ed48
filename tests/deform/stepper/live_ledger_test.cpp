// SPDX-License-Identifier: GPL-3.0-or-later
// The ledger of a body that is computed in part is that of the whole body, whatever is frozen.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/frame_time.h"
#include "core/deform/body/energy_ledger.h"
#include "core/deform/step/assembly.h"
#include "core/deform/step/backward_euler.h"
#include "core/deform/stepper/live_stepper.h"
#include "tests/deform/support/test_bodies.h"

namespace hepatica {
namespace {

BodyDescription tree_in_tissue() {
    BodyDescription body = test::description_of(test::make_brick_tree(5, 3.0, 1.5));
    body.tether_pa_per_mm2 = 200.0;
    // No two neighbours alike: a part that mixes up its elements has other energies.
    for (std::size_t e = 0; e < body.mesh.tetrahedra.size(); ++e) {
        body.stiffness_factor.push_back(0.5 + 0.1 * static_cast<double>(e % 7));
        body.density_factor.push_back(0.7 + 0.1 * static_cast<double>(e % 5));
    }
    return body;
}

// The energies of all nodes and elements at the stepper's positions, by the whole body's sums.
class WholeBody {
  public:
    explicit WholeBody(const BodyDescription& description)
        : body_(build_body(description, ElementModel::corotated, ElementOrder::linear)),
          assembly_(body_),
          potentials_(body_) {}

    EnergyLedger energies(const Stepper& stepper, std::span<const Grab> grabs) {
        const BodyState state = stepper.state();
        potentials_.set_grabs(grabs);
        EnergyLedger ledger;
        ledger.kinetic = kinetic_energy(body_, state.velocities_mm_per_s);
        ledger.elastic = assembly_.energy(state.positions_mm);
        potentials_.book(state.positions_mm, state.positions_mm, ledger);
        return ledger;
    }

  private:
    Body body_;
    Assembly assembly_;
    PotentialList potentials_;
};

// One twig led away and let go, then another: each wakes its own surroundings and sleeps again.
TEST(LiveLedger, IsThatOfTheWholeBodyAndClosesWhileTheRegionChanges) {
    const BodyDescription description = tree_in_tissue();
    const auto live =
        make_live_stepper(description, {}, {.wake_radii = 3e-3, .still_radii_per_s = 1.5e-2});
    WholeBody whole(description);
    const std::vector<Vec3>& rest = description.mesh.vertices_mm;
    const int tips[] = {test::tip_of(description), test::tip_of(description) / 2};
    double stored_before = 0.0, most = 0.0;
    int changes = 0, live_before = 0, smallest = live->extent().elements;
    for (int k = 0; k < 400; ++k) {
        std::vector<Grab> grabs;
        if (k % 200 < 60) {
            const int tip = tips[k / 200];
            Grab grab{.vertices = {tip, -1, -1, -1}};
            grab.target_mm = rest[tip] + Vec3(0.0, 0.03 * (k % 200), 0.0);
            grab.stiffness_un_per_mm = 2e4;
            grab.force_limit_un = 1e5;
            grabs.push_back(grab);
        }
        live->set_grabs(grabs);
        const EnergyLedger ledger = live->step(frame_s).energy;
        const EnergyLedger truth = whole.energies(*live, grabs);
        most = std::max(most, truth.elastic + truth.grab + truth.tether);
        EXPECT_NEAR(ledger.kinetic, truth.kinetic, 1e-9 * most) << "step " << k;
        // What a sleeping body reports: without the speed of nodes that this step has frozen.
        EXPECT_NEAR(live->checkpoint().last_kinetic, truth.kinetic,
                    1e-9 * truth.kinetic + 1e-15 * most)
            << "step " << k;
        EXPECT_NEAR(ledger.elastic, truth.elastic, 1e-9 * most) << "step " << k;
        EXPECT_NEAR(ledger.grab, truth.grab, 1e-9 * most) << "step " << k;
        EXPECT_NEAR(ledger.tether, truth.tether, 1e-9 * most) << "step " << k;
        const double stored = stored_energy(ledger);
        EXPECT_NEAR(stored - stored_before, explained_change(ledger), 1e-9 * most) << "step " << k;
        stored_before = stored;
        const int computed = live->extent().live_elements;
        changes += computed != live_before;
        live_before = computed;
        smallest = std::min(smallest, computed);
    }
    EXPECT_GT(changes, 4);
    EXPECT_LT(smallest, live->extent().elements / 2);
}

// A grab that is given twice before a step, and options that make the part anew, lose no work.
TEST(LiveLedger, LosesNoWorkBetweenTwoSteps) {
    const BodyDescription description = tree_in_tissue();
    const auto live = make_live_stepper(description, {});
    const int tip = test::tip_of(description);
    Grab grab{.vertices = {tip, -1, -1, -1}};
    grab.target_mm = description.mesh.vertices_mm[tip] + Vec3(0.0, 1.0, 0.0);
    grab.stiffness_un_per_mm = 2e4;
    grab.force_limit_un = 1e5;
    const double worth = 0.5 * 2e4;  // of a spring stretched by 1 mm, in nJ
    live->set_grabs(std::span(&grab, 1));
    EXPECT_NEAR(live->energies().tool_work, worth, 1e-6 * worth);
    EXPECT_TRUE(live->set_options({.newton_iterations = 3}));  // another stepper of the part
    EXPECT_NEAR(live->energies().tool_work, worth, 1e-6 * worth);
    live->set_grabs(std::span(&grab, 1));
    EXPECT_NEAR(live->step(frame_s).energy.tool_work, worth, 1e-6 * worth);
    EXPECT_EQ(live->step(frame_s).energy.tool_work, 0.0);
}

}  // namespace
}  // namespace hepatica
