// SPDX-License-Identifier: GPL-3.0-or-later
// A factor that is older than the settings: E of eq. (11) changes after the factor was made and
// before the checkpoint is taken. The restored stepper must make its factor with the E of then, and
// later matrices with the E of now.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/base/frame_time.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/stepper_checkpoint.h"
#include "tests/deform/support/test_bodies.h"

namespace hepatica {
namespace {

constexpr int change_before_step = 2;
constexpr int last_step = 12;
constexpr RayleighDamping error_at_first{.alpha_per_s = 2.0, .beta_s = 1e-3};

struct LaggedCase {
    LinearSolverKind solver;
    int newton_iterations;
    RayleighDamping error_later;  // since change_before_step
};

class LaggedCheckpoint : public testing::TestWithParam<LaggedCase> {
  protected:
    LaggedCheckpoint()
        : body_(test::description_of(test::make_bar(60.0, 3.0, 16, 1))),
          tip_(test::tip_of(body_)) {}

    std::unique_ptr<Stepper> stepper() const { return make_cpu_stepper(body_, options(0)); }

    StepperOptions options(int step) const {
        StepperOptions options;
        options.solver = GetParam().solver;
        options.newton_iterations = GetParam().newton_iterations;
        options.newton_tolerance = 1e-12;       // every iterate is made
        options.linear.energy_tolerance = 0.2;  // met by an old factor after a few iterations
        options.velocity_error =
            step < change_before_step ? error_at_first : GetParam().error_later;
        return options;
    }

    // A slow pull, so that the factor stays good enough.
    void act_before(int step, Stepper& stepper) const {
        Grab grab{.vertices = {tip_, -1, -1, -1}};
        grab.target_mm = body_.mesh.vertices_mm[tip_] + Vec3(0.0, 0.02 * step, 0.01 * step);
        grab.stiffness_un_per_mm = 2e3;
        grab.force_limit_un = 1e5;
        stepper.set_grabs(std::span(&grab, 1));
    }

    BodyDescription body_;
    int tip_;
};

bool equal(const RayleighDamping& a, const RayleighDamping& b) {
    return a.alpha_per_s == b.alpha_per_s && a.beta_s == b.beta_s;
}

TEST_P(LaggedCheckpoint, GoesOnWithTheFactorOfAnEarlierVelocityError) {
    const auto played = stepper();
    std::vector<std::string> checkpoints;
    std::vector<std::vector<Vec3>> velocities;
    std::vector<int> iterations;
    int of_an_earlier_error = 0;
    for (int step = 0; step <= last_step; ++step) {
        if (step == change_before_step) {
            ASSERT_TRUE(played->set_options(options(step)));
        }
        act_before(step, *played);
        iterations.push_back(played->step(frame_s).linear_iterations);
        velocities.emplace_back(played->velocities_mm_per_s().begin(),
                                played->velocities_mm_per_s().end());
        const StepperCheckpoint kept = played->checkpoint();
        checkpoints.push_back(to_bytes(kept));
        ASSERT_TRUE(kept.solver.made_from);
        if (step >= change_before_step &&
            equal(kept.solver.made_from->velocity_error, error_at_first))
            ++of_an_earlier_error;
    }
    ASSERT_GE(of_an_earlier_error, 2) << "no factor outlived the change: this test checks nothing";
    for (int from = change_before_step; from < last_step; ++from) {
        const auto restored = stepper();
        ASSERT_TRUE(restored->set_options(options(from)));
        restored->restore(checkpoint_from_bytes(checkpoints[from]));
        for (int step = from + 1; step <= last_step; ++step) {
            act_before(step, *restored);
            ASSERT_EQ(restored->step(frame_s).linear_iterations, iterations[step])
                << step << " from " << from;
            const std::vector<Vec3> now(restored->velocities_mm_per_s().begin(),
                                        restored->velocities_mm_per_s().end());
            ASSERT_EQ(now, velocities[step]) << step << " from " << from;
        }
    }
}

std::vector<LaggedCase> lagged_cases() {
    std::vector<LaggedCase> cases;
    // Of the others none keeps anything of an earlier matrix.
    for (const int newton_iterations : {1, 3})
        for (const RayleighDamping later : {RayleighDamping{}, RayleighDamping{3.0, 5e-4}})
            cases.push_back({LinearSolverKind::skeleton, newton_iterations, later});
    return cases;
}

std::string name_of_lagged_case(const testing::TestParamInfo<LaggedCase>& info) {
    return std::string(name_of(info.param.solver)) +
           (info.param.newton_iterations > 1 ? "_newton" : "_one_iterate") +
           (info.param.error_later.alpha_per_s > 0.0 ? "_another_error" : "_no_error_any_more");
}

INSTANTIATE_TEST_SUITE_P(All, LaggedCheckpoint, testing::ValuesIn(lagged_cases()),
                         name_of_lagged_case);

}  // namespace
}  // namespace hepatica
