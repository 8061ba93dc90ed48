// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of the GPU's back end against the CPU's, which computes them by other code: its assembly
// sums otherwise, its matrix stores the diagonal, its solver is another. Emulated, and on the
// device where there is one.
#include "gpu/cuda_back_end.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/frame_time.h"
#include "core/deform/stepper/cpu_back_end.h"
#include "core/deform/stepper/governed_stepper.h"
#include "core/mesh/brick_mesh.h"
#include "gpu/machine/device_error.h"
#include "tests/deform/support/two_bars.h"
#include "tests/gpu/support/gpu_bodies.h"

namespace hepatica {
namespace {

using gpu::BlockOrder;
using gpu::Precision;
using test::difference;
using test::relative_distance;

struct Case {
    std::string machine, element;
    LinearSolverKind solver = LinearSolverKind::block_jacobi;
};
std::string name_of_case(const testing::TestParamInfo<Case>& info) {
    std::string name = info.param.machine + "_" + info.param.element;
    if (info.param.solver == LinearSolverKind::skeleton) name += "_skeleton";
    std::ranges::replace(name, '-', '_');
    return name;
}

// Both back ends of one body, in the same state and under the same pull.
class TwoBackEnds : public testing::TestWithParam<Case> {
  protected:
    void SetUp() override {
        machine_ = test::machine_of(GetParam().machine);
        if (!machine_) GTEST_SKIP() << test::no_device_because();
    }
    void make(Precision precision) {
        description_ = test::gpu_bar();
        options_ = test::exact_options(GetParam().element);
        options_.solver = GetParam().solver;
        if (precision == Precision::single_precision) options_.linear.residual_tolerance = 1e-6;
        cpu_ = make_cpu_back_end(description_, options_);
        gpu_ = gpu::make_cuda_back_end(description_, options_, machine_,
                                       {precision, share_, [&](const auto& why) { said_ += why; }});
        for (StepBackEnd* one : {cpu_.get(), gpu_.get()}) {
            one->set_gravity({0.0, -9810.0, 0.0});
            const Grab grab = test::pull_at_end(description_);
            one->set_grabs({&grab, 1});
        }
    }
    void begin_at(const BodyState& state) {
        cpu_->set_state(state);
        gpu_->set_state(state);
    }
    // Of the motion of the step, and of the velocities at its end.
    double distance_after_step(const BodyState& start) {
        begin_at(start);
        cpu_report_ = cpu_->advance(frame_s);
        gpu_report_ = gpu_->advance(frame_s);
        EXPECT_EQ(share_->device, 1);
        const auto moved = [&](const StepBackEnd& one) {
            return difference(one.state().positions_mm, start.positions_mm);
        };
        return std::max(relative_distance(moved(*gpu_), moved(*cpu_)),
                        relative_distance(gpu_->state().velocities_mm_per_s,
                                          cpu_->state().velocities_mm_per_s));
    }
    // Every term of the GPU's ledger is the CPU's, up to a share of the energies at hand.
    void expect_same_books(double share) const {
        const EnergyLedger &a = gpu_report_.energy, &b = cpu_report_.energy;
        const double size = share * energy_handled(b);
        EXPECT_NEAR(a.kinetic, b.kinetic, size);
        EXPECT_NEAR(a.elastic, b.elastic, size);
        EXPECT_NEAR(a.grab, b.grab, size);
        EXPECT_NEAR(a.tether, b.tether, size);
        EXPECT_NEAR(a.gravity_work, b.gravity_work, size);
        EXPECT_NEAR(a.damping_loss, b.damping_loss, size);
        EXPECT_NEAR(a.integrator_loss, b.integrator_loss, size);
        EXPECT_NEAR(a.nonlinear_loss, b.nonlinear_loss, size);
        EXPECT_NEAR(a.limiter_loss, b.limiter_loss, size);
        EXPECT_NEAR(a.solver_work, b.solver_work, size);
        EXPECT_NEAR(a.imbalance, 0.0, size);
    }

    std::shared_ptr<gpu::Machine> machine_;
    BodyDescription description_;
    StepperOptions options_;
    std::unique_ptr<StepBackEnd> cpu_, gpu_;
    StepReport cpu_report_, gpu_report_;
    std::shared_ptr<gpu::StepShare> share_ = std::make_shared<gpu::StepShare>();
    std::string said_;
};

TEST_P(TwoBackEnds, OneStepFromRestAgreesInDouble) {
    make(Precision::double_precision);
    BodyState rest{cpu_->body().rest_positions_mm, {}};
    rest.velocities_mm_per_s.assign(rest.positions_mm.size(), Vec3::Zero());
    EXPECT_LT(distance_after_step(rest), 1e-10);
    expect_same_books(1e-10);
    EXPECT_FALSE(gpu_report_.predicted);
    EXPECT_EQ(said_, "");
}

TEST_P(TwoBackEnds, OneStepOfABentMovingBodyAgreesInDouble) {
    make(Precision::double_precision);
    EXPECT_LT(distance_after_step(test::lively(cpu_->body())), 1e-10);
    EXPECT_EQ(gpu_report_.predicted, cpu_report_.predicted);
    expect_same_books(1e-10);
}

TEST_P(TwoBackEnds, OneStepAgreesInFloat) {
    make(Precision::single_precision);
    EXPECT_LT(distance_after_step(test::lively(cpu_->body())), 1e-4);
    expect_same_books(1e-4);
}

TEST_P(TwoBackEnds, ThreeHundredStepsAgreeInDouble) {
    make(Precision::double_precision);
    const BodyState start = test::lively(cpu_->body());
    begin_at(start);
    for (int k = 0; k < 300; ++k) {
        cpu_->advance(frame_s);
        gpu_->advance(frame_s);
    }
    EXPECT_LT(relative_distance(difference(gpu_->state().positions_mm, start.positions_mm),
                                difference(cpu_->state().positions_mm, start.positions_mm)),
              1e-8);
    EXPECT_GE(share_->device, 290);
}

// What is frozen stays, and the rest moves as the CPU has it.
TEST_P(TwoBackEnds, FrozenNodesStay) {
    make(Precision::double_precision);
    BodyState start = test::lively(cpu_->body());
    std::vector<std::uint8_t> frozen(start.positions_mm.size(), 0);
    for (std::size_t i = 0; i < frozen.size(); ++i)
        if (start.positions_mm[i].x() < 12.0) {
            frozen[i] = 1;
            start.velocities_mm_per_s[i].setZero();
        }
    cpu_->freeze(frozen);
    gpu_->freeze(frozen);
    EXPECT_LT(distance_after_step(start), 1e-10);
    for (std::size_t i = 0; i < frozen.size(); ++i)
        if (frozen[i] != 0) {
            EXPECT_EQ(gpu_->state().positions_mm[i], start.positions_mm[i]);
        }
}

INSTANTIATE_TEST_SUITE_P(
    Gpu, TwoBackEnds,
    testing::Values(Case{"emulated", "corotated"}, Case{"emulated", "neohookean"},
                    Case{"emulated", "spring"}, Case{"emulated", "corotated-10"},
                    Case{"emulated", "corotated", LinearSolverKind::skeleton},
                    Case{"emulated", "corotated-10", LinearSolverKind::skeleton},
                    Case{"device", "corotated", LinearSolverKind::skeleton},
                    Case{"device", "corotated"}, Case{"device", "neohookean"},
                    Case{"device", "spring"}, Case{"device", "corotated-10"}),
    name_of_case);

// A body and what its back end says of the processor's part in it.
struct Played {
    Played(const BodyDescription& body, const StepperOptions& options,
           std::shared_ptr<gpu::Machine> on, Precision precision) {
        gpu::CudaOptions cuda{.precision = precision};
        cuda.say = [this](const std::string& why) { said.push_back(why); };
        back_end = gpu::make_cuda_back_end(body, options, std::move(on), cuda);
        back_end->set_gravity({0.0, -9810.0, 0.0});
        back_end->set_state(test::lively(back_end->body()));
    }
    std::vector<std::string> said;
    std::unique_ptr<StepBackEnd> back_end;
};

TEST(CudaBackEnd, AnyOrderOfBlocksGivesTheSameBits) {
    const BodyDescription body = description_of(test::make_brick_tree(3, 4.0, 2.0));
    const StepperOptions options = [] {
        StepperOptions o;
        o.linear.max_iterations = 200;
        return o;
    }();
    std::vector<BodyState> ends;
    for (const BlockOrder order :
         {BlockOrder::ascending, BlockOrder::descending, BlockOrder::shuffled}) {
        Played played(body, options, gpu::make_emulator(order), Precision::single_precision);
        for (int k = 0; k < 5; ++k) played.back_end->advance(frame_s);
        EXPECT_THAT(played.said, testing::ElementsAre(testing::HasSubstr("tension")));
        ends.push_back(played.back_end->state());
    }
    for (const BodyState& end : ends) {
        EXPECT_EQ(end.positions_mm, ends[0].positions_mm);
        EXPECT_EQ(end.velocities_mm_per_s, ends[0].velocities_mm_per_s);
    }
}

// Without the skeleton a vessel's bending takes more iterations than there is time for.
TEST(CudaBackEnd, TheSkeletonSavesMostIterations) {
    const BodyDescription body = description_of(test::make_bar(120.0, 6.0, 40, 2));
    const auto iterations = [&](LinearSolverKind solver, Precision precision) {
        StepperOptions options = test::exact_options("corotated");
        options.solver = solver;
        options.linear = {.energy_tolerance = 1e-3};
        Played played(body, options, gpu::make_emulator(), precision);
        const StepReport report = played.back_end->advance(frame_s);
        EXPECT_TRUE(played.said.empty());
        EXPECT_LT(report.linear_energy_error, 1e-3);
        return report.linear_iterations;
    };
    for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
        const int plain = iterations(LinearSolverKind::block_jacobi, precision);
        const int two_level = iterations(LinearSolverKind::skeleton, precision);
        EXPECT_GT(plain, 400);
        EXPECT_LT(two_level, 50);
    }
}

// In float a body at rest has the energies of its rounding, which no step lowers for certain.
TEST(CudaBackEnd, ABodyAtRestStaysThereOnTheDevice) {
    const gpu::CudaOptions cuda;
    BodyDescription bar = test::gpu_bar();
    for (Vec3& x : bar.mesh.vertices_mm) x = test::bend({x}, 0.7, 24.0).front() / 3.0;
    const auto back_end =
        gpu::make_cuda_back_end(bar, StepperOptions{}, gpu::make_emulator(), cuda);
    for (int k = 0; k < 20; ++k) {
        const StepReport report = back_end->advance(frame_s);
        EXPECT_FALSE(report.degraded) << report.message;
    }
    EXPECT_EQ(cuda.share->device, 20);
    const Body& body = back_end->body();
    EXPECT_LT(relative_distance(back_end->state().positions_mm, body.rest_positions_mm), 1e-6);
}

// A step without a right-hand side solves nothing; it was booked with what another had cost.
TEST(CudaBackEnd, BooksNothingWhereNothingIsSolved) {
    const gpu::CudaOptions cuda;
    BodyDescription brick;  // of cells of a millimetre, which have no forces of rounding at rest
    brick.mesh = kuhn_brick(Vec3(8, 2, 2), {8, 2, 2});
    for (const Vec3& x : brick.mesh.vertices_mm) brick.fixed.push_back(x.x() == 0.0 ? 1 : 0);
    const auto back_end = gpu::make_cuda_back_end(brick, test::exact_options("corotated"),
                                                  gpu::make_emulator(), cuda);
    const BodyState rest = back_end->state();
    back_end->set_gravity({0.0, -9810.0, 0.0});
    back_end->advance(frame_s);
    const gpu::SolveCost moved = cuda.share->solves;
    EXPECT_GT(moved.kernel_bytes, 0u);
    EXPECT_GT(moved.seconds, 0.0);
    back_end->set_gravity(Vec3::Zero());
    back_end->set_state(rest);
    EXPECT_EQ(back_end->advance(frame_s).linear_iterations, 0);
    EXPECT_EQ(cuda.share->device, 2);
    EXPECT_EQ(cuda.share->solves.kernel_bytes, moved.kernel_bytes);
    EXPECT_EQ(cuda.share->solves.seconds, moved.seconds);
}

// The processor's steps of these elements have tension; the device's have not, which is said once.
TEST(CudaBackEnd, SaysThatItLeavesOutTension) {
    for (const char* model : {"corotated", "neohookean", "spring", "corotated-10"})
        for (const bool tension : {true, false}) {
            StepperOptions options = test::exact_options(model);
            options.tension = tension;
            Played played(test::gpu_bar(), options, gpu::make_emulator(),
                          Precision::double_precision);
            for (int k = 0; k < 2; ++k) played.back_end->advance(frame_s);
            const bool left_out = tension && std::string(model) == "corotated";
            EXPECT_EQ(std::ranges::count_if(
                          played.said,
                          [](const auto& said) { return said.find("tension") != said.npos; }),
                      left_out ? 1 : 0)
                << model;
        }
}

// What has no kernels is computed by the processor, to its bits, and said once.
TEST(CudaBackEnd, LeavesToTheProcessorWhatHasNoKernels) {
    StepperOptions newton = test::exact_options("corotated"), cholesky = newton;
    newton.newton_iterations = 4;
    cholesky.solver = LinearSolverKind::cholesky;
    for (const StepperOptions& options : {test::exact_options("neohookean-10"), newton, cholesky}) {
        const BodyDescription body = test::gpu_bar();
        const std::shared_ptr<gpu::Machine> machine = gpu::make_emulator();
        Played played(body, options, machine, Precision::double_precision);
        const auto cpu = make_cpu_back_end(body, options);
        cpu->set_gravity({0.0, -9810.0, 0.0});
        cpu->set_state(played.back_end->state());
        for (int k = 0; k < 3; ++k) {
            cpu->advance(frame_s);
            played.back_end->advance(frame_s);
        }
        EXPECT_EQ(machine->traffic().launches, 0);
        EXPECT_THAT(played.said, testing::ElementsAre(testing::HasSubstr("no kernels")));
        EXPECT_EQ(played.back_end->state().positions_mm, cpu->state().positions_mm);
    }
}

// A tool that is far away changes nothing.
TEST(CudaBackEnd, MakesStepsBesideATool) {
    BodyDescription body = test::gpu_bar();
    body.touchable = true;
    const std::shared_ptr<gpu::Machine> machine = gpu::make_emulator();
    const auto play = [&](bool with_tool) {
        Played played(body, test::exact_options("corotated"), machine, Precision::double_precision);
        Tool tool = single_tool(Capsule{Vec3(12.0, 100.0, 0.0), Vec3::Zero(), 1.0});
        tool.target_mm = tool.centre_mm();
        tool.pad_mm = 0.1;
        tool.pressure_pa = 1e6;
        if (with_tool) played.back_end->set_tool(tool);
        const long before = machine->traffic().launches;
        played.back_end->advance(frame_s);
        EXPECT_GT(machine->traffic().launches, before);
        EXPECT_TRUE(played.said.empty());
        return played.back_end->state();
    };
    EXPECT_EQ(play(true).positions_mm, play(false).positions_mm);
}

// Two bars that fly at each other: the CPU begins such a step at the velocity of the centre of
// mass. That it makes the step is said once.
TEST(CudaBackEnd, SaysThatItLeavesAFreeBodyThatMeetsItself) {
    const BodyDescription bars = test::crossed_bars(0.5);
    std::vector<std::string> said;
    gpu::CudaOptions cuda;
    cuda.say = [&](const std::string& why) { said.push_back(why); };
    const auto back_end =
        gpu::make_cuda_back_end(bars, test::exact_options("corotated"), gpu::make_emulator(), cuda);
    BodyState state = back_end->state();
    const std::size_t half = state.positions_mm.size() / 2;
    for (std::size_t i = half; i < 2 * half; ++i) state.velocities_mm_per_s[i] = Vec3(0, 0, -20);
    back_end->set_state(state);
    for (int k = 0; k < 6; ++k) back_end->advance(frame_s);
    EXPECT_GT(cuda.share->processor, 0);
    EXPECT_GT(cuda.share->device, 0);
    EXPECT_EQ(std::ranges::count_if(
                  said, [](const auto& why) { return why.find("free body") != why.npos; }),
              1);
}

// Sleep, substeps and checkpoints are the governor's, whatever the back end.
TEST(CudaBackEnd, ContinuesFromACheckpointToTheBit) {
    const std::shared_ptr<gpu::Machine> machine = gpu::make_emulator();
    const auto make = [&] {
        return GovernedStepper(test::gpu_bar(), StepperOptions{}, std::nullopt,
                               [&](const BodyDescription& body, const StepperOptions& options) {
                                   return gpu::make_cuda_back_end(body, options, machine);
                               });
    };
    GovernedStepper one = make(), other = make();
    one.set_gravity({0.0, -9810.0, 0.0});
    for (int k = 0; k < 4; ++k) one.step(frame_s);
    other.restore(one.checkpoint());
    EXPECT_EQ(one.state_hash(), other.state_hash());
    for (int k = 0; k < 4; ++k) {
        one.step(frame_s);
        other.step(frame_s);
        EXPECT_EQ(one.state_hash(), other.state_hash());
    }
}

}  // namespace
}  // namespace hepatica
