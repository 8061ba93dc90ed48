// SPDX-License-Identifier: GPL-3.0-or-later
// What the trial of a body lets pass and what not, by ledgers made up for it.
#include "core/study/trial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "core/deform/stepper/cpu_stepper.h"
#include "core/mesh/brick_mesh.h"

namespace hepatica {
namespace {

class TrialOfLedgers : public testing::Test {
  protected:
    static BodyDescription small_body() {
        BodyDescription body;
        body.mesh = kuhn_brick(Vec3(1, 1, 1), {1, 1, 1});
        return body;
    }

    BodyDescription body_ = small_body();
    std::unique_ptr<Stepper> stepper_ = make_cpu_stepper(body_, {});
    ExtremeRow row_;
};

// A body of 100 nJ that loses `loss` to damping, and of which `made` comes from nowhere.
StepReport after_a_loss(double loss, double made = 0.0) {
    StepReport report;
    EnergyLedger& ledger = report.energy;
    ledger.kinetic = 0.3 * (100.0 - loss);
    ledger.elastic = 0.7 * (100.0 - loss) + made;
    ledger.damping_loss = loss;
    return report;
}

StepReport of_100_nj() {
    return after_a_loss(0.0);
}

TEST_F(TrialOfLedgers, PassesWhatIsBooked) {
    Trial trial(*stepper_, row_, {});
    EXPECT_TRUE(trial.check_energy(of_100_nj()));
    EXPECT_TRUE(trial.check_energy(after_a_loss(20.0)));
    StepReport lifted = after_a_loss(20.0);  // 80 nJ before; gravity and the tool bring 50
    lifted.energy.elastic += 45.0;
    lifted.energy.gravity_work = 60.0;
    lifted.energy.tool_work = -10.0;
    lifted.energy.damping_loss = 2.0;
    lifted.energy.integrator_loss = 4.0;
    lifted.energy.solver_work = 1.0;
    EXPECT_TRUE(trial.check_energy(lifted)) << row_.note;
    EXPECT_TRUE(row_.note.empty());
    EXPECT_LE(row_.energy_made, 0.0);
}

TEST_F(TrialOfLedgers, FailsWhereEnergyIsMade) {
    Trial trial(*stepper_, row_, {});
    EXPECT_TRUE(trial.check_energy(of_100_nj()));
    StepReport more = of_100_nj();
    more.energy.elastic += 1.0;
    more.energy.solver_work = 1.0;  // booked, and yet more than before
    EXPECT_FALSE(trial.check_energy(more));
    EXPECT_EQ(row_.note, "energy was made");
    EXPECT_NEAR(row_.energy_made, 1.0 / 202.0, 1e-12);  // of 100 before, 101 stored, 1 of work
}

TEST_F(TrialOfLedgers, FailsWhereTheLedgerLeavesALossOpen) {
    for (const double open : {1e-8, 0.1}) {
        ExtremeRow row;
        Trial trial(*stepper_, row, {});
        EXPECT_TRUE(trial.check_energy(of_100_nj()));
        EXPECT_FALSE(trial.check_energy(after_a_loss(20.0, -100.0 * 2.2 * open)));
        EXPECT_NE(row.note.find("the ledger leaves"), std::string::npos) << row.note;
    }
}

// Gaps between energies and forces, of a body of 100 nJ: some small enough, and one that is not.
TEST_F(TrialOfLedgers, KeepsTheLargestGapOfTheAuditAndFailsWhereItIsTooLarge) {
    const auto with_gap = [](double gap_nj) {
        StepReport report = of_100_nj();
        report.energy.nonlinear_loss = -gap_nj;
        report.audit_gap_nj = gap_nj;
        return report;
    };
    Trial trial(*stepper_, row_, {});
    EXPECT_TRUE(trial.check_energy(of_100_nj()));
    EXPECT_TRUE(trial.check_energy(with_gap(5e-4))) << row_.note;
    const double found = row_.audit_gap;
    EXPECT_NEAR(found, 5e-4 / 200.0, 1e-8);  // of 100 before and 100 after
    EXPECT_TRUE(trial.check_energy(with_gap(1e-4)));
    EXPECT_EQ(row_.audit_gap, found);
    EXPECT_FALSE(trial.check_energy(with_gap(1e-2)));
    EXPECT_NE(row_.note.find("energies and forces differ"), std::string::npos) << row_.note;
}

// A loss at first must not hide that energy is made later.
TEST_F(TrialOfLedgers, JudgesEveryStepAlone) {
    Trial trial(*stepper_, row_, {});
    EXPECT_TRUE(trial.check_energy(of_100_nj()));
    EXPECT_TRUE(trial.check_energy(after_a_loss(50.0)));
    EXPECT_FALSE(trial.check_energy(after_a_loss(0.0, -40.0)));  // 60 nJ, after 50
}

// Neither is larger or smaller than a bound, so that comparisons alone let them pass; after an
// infinite energy whatever came passed.
TEST_F(TrialOfLedgers, FailsWhereAnEnergyIsNotFinite) {
    for (const double value : {std::nan(""), HUGE_VAL})
        for (double EnergyLedger::*term :
             {&EnergyLedger::kinetic, &EnergyLedger::elastic, &EnergyLedger::damping_loss}) {
            ExtremeRow row;
            Trial trial(*stepper_, row, {});
            EXPECT_TRUE(trial.check_energy(of_100_nj()));
            StepReport spoiled = of_100_nj();
            spoiled.energy.*term = value;
            EXPECT_FALSE(trial.check_energy(spoiled)) << value;
            EXPECT_EQ(row.note, "the ledger of energies is not finite");
        }
}

// At rest only rounding of the energies that once were is left: 1e-9 of the most handled passes.
TEST_F(TrialOfLedgers, LetsABodyAtRestHaveTheRoundingOfItsEnergies) {
    Trial trial(*stepper_, row_, {});
    EXPECT_TRUE(trial.check_energy(of_100_nj()));
    EXPECT_TRUE(trial.check_energy(after_a_loss(100.0)));
    StepReport rounding;
    rounding.energy.kinetic = 1e-20;
    EXPECT_TRUE(trial.check_energy(rounding)) << row_.note;
    rounding.energy.kinetic = 1e-6;  // but not more
    EXPECT_FALSE(trial.check_energy(rounding));
}

TEST_F(TrialOfLedgers, NeverHandlingAnythingIsNothingWrong) {
    Trial trial(*stepper_, row_, {});
    EXPECT_TRUE(trial.check_energy({}));
    EXPECT_TRUE(trial.check_energy({}));
    EXPECT_EQ(row_.energy_made, 0.0);
}

// With a share given, small steps are judged against the largest.
TEST_F(TrialOfLedgers, JudgesTheOpenRestAgainstAShareOfTheLargestStep) {
    for (const double share : {0.0, 1.0}) {
        ExtremeRow row;
        Trial trial(*stepper_, row, {}, share);
        EXPECT_TRUE(trial.check_energy(of_100_nj()));
        StepReport small = after_a_loss(99.0);
        EXPECT_TRUE(trial.check_energy(small));
        small.energy.damping_loss = 0.5;
        small.energy.elastic -= 0.5 + 1e-8;  // 1e-8 of 1 nJ, 1e-10 of 100 nJ
        EXPECT_EQ(trial.check_energy(small), share == 1.0) << row.note;
    }
}

TEST_F(TrialOfLedgers, TakesEnergyAtTheStartFromTheFirstLedger) {
    Trial trial(*stepper_, row_, {});
    StepReport first = of_100_nj();
    first.energy.imbalance = -1.0;  // 1 nJ was lost and nobody knows where
    EXPECT_FALSE(trial.check_energy(first));
    EXPECT_NE(row_.note.find("open"), std::string::npos) << row_.note;
}

TEST_F(TrialOfLedgers, ComparesWithReferencesRelatively) {
    Trial trial(*stepper_, row_, {});
    EXPECT_TRUE(trial.require_close(-2.1, -2.0, 0.0501, "a book"));
    EXPECT_NEAR(row_.error, 0.05, 1e-12);
    EXPECT_EQ(row_.reference, "a book");
    EXPECT_TRUE(row_.note.empty());
    EXPECT_FALSE(trial.require_close(2.1, 2.0, 0.0499, "a book"));
    EXPECT_FALSE(row_.note.empty());
    EXPECT_FALSE(trial.require_close(std::nan(""), 2.0, 1.0, "a book"));
}

TEST_F(TrialOfLedgers, JudgesManyValuesByTheOneFurthestAway) {
    for (const double far : {1.5, 2.5}) {
        ExtremeRow row;
        Trial trial(*stepper_, row, {});
        EXPECT_FALSE(trial.require_all_close(std::vector{2.01, far, 2.0}, 2.0, 0.1, "a book"));
        EXPECT_NEAR(row.error, 0.25, 1e-12);
        EXPECT_TRUE(row.note.starts_with(far < 2.0 ? "1.5 " : "2.5 ")) << row.note;
    }
    Trial trial(*stepper_, row_, {});
    EXPECT_TRUE(trial.require_all_close(std::vector{2.01, 2.1, 1.99}, 2.0, 0.1, "a book"));
    EXPECT_NEAR(row_.error, 0.05, 1e-12);
    for (const std::vector<double>& spoiled :
         {std::vector{2.0, std::nan(""), 2.1}, std::vector{std::nan(""), 2.0}}) {
        ExtremeRow row;
        EXPECT_FALSE(Trial(*stepper_, row, {}).require_all_close(spoiled, 2.0, 1.0, "a book"));
        EXPECT_FALSE(row.note.empty());
    }
}

TEST_F(TrialOfLedgers, AllowsWhatIsJustAllowed) {
    Trial trial(*stepper_, row_, {});
    EXPECT_TRUE(trial.require_close(3.0, 2.0, 0.5, "a book"));
    EXPECT_EQ(row_.error, 0.5);
}

TEST_F(TrialOfLedgers, KeepsTheFirstReason) {
    Trial trial(*stepper_, row_, {});
    EXPECT_TRUE(trial.require(true, "fine"));
    EXPECT_TRUE(row_.note.empty());
    EXPECT_FALSE(trial.require(false, "first"));
    EXPECT_FALSE(trial.require(false, "second"));
    EXPECT_EQ(row_.note, "first");
}

TEST_F(TrialOfLedgers, ComparesPlacesWithThoseBefore) {
    Trial trial(*stepper_, row_, {});
    std::vector<Vec3> places = body_.mesh.vertices_mm;
    places[3].x() += 0.5;
    EXPECT_TRUE(trial.require_back_at(places, 0.51));
    EXPECT_FALSE(trial.require_back_at(places, 0.49));
}

}  // namespace
}  // namespace hepatica
