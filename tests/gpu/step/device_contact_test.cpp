// SPDX-License-Identifier: GPL-3.0-or-later
// Contact on the GPU's back end against the CPU's: single steps from the same state with each kind
// of contact and its friction, the books of it, and the same bits in any order of blocks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "core/base/frame_time.h"
#include "core/deform/stepper/cpu_back_end.h"
#include "gpu/cuda_back_end.h"
#include "tests/gpu/support/gpu_bodies.h"
#include "tests/gpu/support/touching_bodies.h"

namespace hepatica {
namespace {

using gpu::BlockOrder;
using gpu::Precision;
using test::difference;
using test::relative_distance;
using test::touching_body;
using test::TouchingBody;

StepperOptions options_of(LinearSolverKind solver, Precision precision) {
    StepperOptions options = test::exact_options("corotated");
    options.solver = solver;
    options.tension = false;
    if (precision == Precision::single_precision) options.linear.residual_tolerance = 1e-10;
    return options;
}

int contacts(const StepReport& report) {
    return report.tool.contacts + report.self.contacts + report.obstacles.touch.contacts;
}

// Steps of both back ends, each from the CPU's state.
class Contact : public testing::TestWithParam<std::string> {
  protected:
    struct Difference {
        double motion = 0.0, books = 0.0;
        double median = 0.0;      // in motion
        double of_solvers = 0.0;  // in motion, of the CPU's iterative solver from its direct one
        int steps = 0;            // that the device made while something touched
        std::string at;           // of the one that differs most
    };
    static std::string words_of(int step, const StepReport& report, const StepReport& expected) {
        std::ostringstream words;
        words << "step " << step;
        for (const StepReport* one : {&report, &expected})
            words << "; iterates " << one->newton_iterations << ", iterations "
                  << one->linear_iterations << ", residual " << one->linear_residual
                  << ", predicted " << one->predicted << ", contacts " << contacts(*one) << ", "
                  << one->message << ", limiter " << one->energy.limiter_loss;
        return words.str();
    }
    // Terms of the ledger, over the energies at hand.
    static double difference_of_books(const EnergyLedger& a, const EnergyLedger& b) {
        double most = 0.0;
        for (const double d :
             {a.kinetic - b.kinetic, a.elastic - b.elastic, a.grab - b.grab, a.contact - b.contact,
              a.tool_work - b.tool_work, a.friction_loss - b.friction_loss,
              a.damping_loss - b.damping_loss, a.integrator_loss - b.integrator_loss,
              a.nonlinear_loss - b.nonlinear_loss, a.solver_work - b.solver_work, a.imbalance})
            most = std::max(most, std::abs(d));
        return most / energy_handled(b);
    }
    static void take_over(const StepBackEnd& from, StepBackEnd& to) {
        to.set_state(from.state());
        to.set_overlaps(from.overlaps());
        to.set_tool(from.tool());
    }
    // Over the larger of motion and velocity.
    static double difference_of_steps(const BodyState& start, const StepBackEnd& one,
                                      const StepBackEnd& expected) {
        const auto moved = [&](const StepBackEnd& any) {
            return difference(any.state().positions_mm, start.positions_mm);
        };
        return std::max(relative_distance(moved(one), moved(expected)),
                        relative_distance(one.state().velocities_mm_per_s,
                                          expected.state().velocities_mm_per_s));
    }
    Difference play(Precision precision, int steps) {
        TouchingBody body = touching_body(GetParam());
        const auto iterative = options_of(LinearSolverKind::block_jacobi, precision);
        const auto cpu = make_cpu_back_end(
            body.description, options_of(LinearSolverKind::cholesky, Precision::double_precision));
        const auto other = precision == Precision::double_precision
                               ? make_cpu_back_end(body.description, iterative)
                               : nullptr;
        const gpu::CudaOptions cuda{.precision = precision};
        StepperOptions refined = iterative;
        if (precision == Precision::double_precision) refined.linear.residual_tolerance = 1e-15;
        const auto gpu =
            gpu::make_cuda_back_end(body.description, refined, gpu::make_emulator(), cuda);
        cpu->set_tool(body.tool);
        Difference most;
        std::vector<double> all;
        for (int k = 0; k < steps; ++k) {
            lead(body, *cpu, frame_s);
            const BodyState start = cpu->state();
            for (StepBackEnd* one : {static_cast<StepBackEnd*>(other.get()), gpu.get()}) {
                if (one == nullptr) continue;
                take_over(*cpu, *one);
                if (body.grab) one->set_grabs({&*body.grab, 1});
            }
            const long made = cuda.share->device;
            const StepReport expected = cpu->advance(frame_s), report = gpu->advance(frame_s);
            const StepReport of_other = other ? other->advance(frame_s) : StepReport{};
            if (cuda.share->device == made || contacts(expected) == 0) continue;
            EXPECT_EQ(contacts(report), contacts(expected));
            rubbed_ = rubbed_ || expected.energy.friction_loss != 0.0;
            // Steps that the CPU made in two iterates, or whose system it did not solve as far as
            // it was asked to, are others.
            if (!comparable(expected) || !comparable(report)) continue;
            ++most.steps;
            const double apart = difference_of_steps(start, *gpu, *cpu);
            if (other && comparable(of_other))
                most.of_solvers =
                    std::max(most.of_solvers, difference_of_steps(start, *other, *cpu));
            if (apart > most.motion) most.at = words_of(k, report, expected);
            most.motion = std::max(most.motion, apart);
            all.push_back(apart);
            most.books = std::max(most.books, difference_of_books(report.energy, expected.energy));
        }
        std::ranges::sort(all);
        if (!all.empty()) most.median = all[all.size() / 2];
        record("motion", most.motion);
        record("median", most.median);
        record("books", most.books);
        record("of_solvers", most.of_solvers);
        return most;
    }
    static void record(const std::string& what, double value) {
        std::ostringstream words;
        words << value;
        RecordProperty(what, words.str());
    }
    static bool comparable(const StepReport& report) {
        return report.newton_iterations == 1 && !report.shortened && report.linear_residual < 1e-6;
    }
    bool rubbed_ = false;
};

// Where the CPU's own two solvers differ by more than 1e-10 the device may differ from the direct
// one by twice as much. What sticks is bound by stiffness so great that residuals of 1e-15 leave
// 1e-10 of the motion open; the CPU solves it by one factor whatever its solver is, so that the two
// do not show it there.
TEST_P(Contact, StepsAgreeInDouble) {
    const Difference found = play(Precision::double_precision, 55);
    EXPECT_GT(found.steps, 20);
    const bool sticks = GetParam() == "self-friction" || GetParam() == "everything";
    const double bound = std::max(sticks ? 1e-9 : 1e-10, 2.0 * found.of_solvers);
    EXPECT_LT(found.motion, bound) << found.at;
    EXPECT_LT(found.books, bound);
    EXPECT_EQ(rubbed_, GetParam() != "self");
}

// The matrix is float, and all that the step is measured by is double: so that little that moves
// beside a stiff contact keeps its digits, and what sticks, too.
TEST_P(Contact, StepsAgreeInFloat) {
    const Difference found = play(Precision::single_precision, 55);
    EXPECT_GT(found.steps, 20);
    EXPECT_LT(found.median, 1e-5);
    EXPECT_LT(found.motion, 1e-4) << found.at;
    EXPECT_LT(found.books, 1e-5);
}

TEST_P(Contact, AnyOrderOfBlocksGivesTheSameBits) {
    StepperOptions quick = options_of(LinearSolverKind::block_jacobi, Precision::single_precision);
    quick.linear = {.max_iterations = 200};
    std::vector<BodyState> ends;
    for (const BlockOrder order : {BlockOrder::ascending, BlockOrder::descending,
                                   BlockOrder::shuffled, BlockOrder::ascending}) {
        TouchingBody body = touching_body(GetParam());
        const gpu::CudaOptions cuda;
        const auto gpu =
            gpu::make_cuda_back_end(body.description, quick, gpu::make_emulator(order), cuda);
        gpu->set_tool(body.tool);
        int touched = 0;
        for (int k = 0; k < 50; ++k) {
            lead(body, *gpu, frame_s);
            touched += contacts(gpu->advance(frame_s)) > 0 ? 1 : 0;
        }
        EXPECT_GT(touched, 5);
        EXPECT_GT(cuda.share->device, 15);
        ends.push_back(gpu->state());
    }
    for (const BodyState& end : ends) {
        EXPECT_EQ(end.positions_mm, ends[0].positions_mm);
        EXPECT_EQ(end.velocities_mm_per_s, ends[0].velocities_mm_per_s);
    }
}

// A bar that swings towards a ball within one step: what both parts' solves cost is booked, which
// is all but a little of what such a step does.
TEST(CudaBackEnd, BooksTheSolvesOfEachPartOfAStep) {
    const TouchingBody body = touching_body("obstacle");
    const auto options = options_of(LinearSolverKind::block_jacobi, Precision::single_precision);
    const gpu::CudaOptions cuda;
    const std::shared_ptr<gpu::Machine> machine = gpu::make_emulator();
    const auto gpu = gpu::make_cuda_back_end(body.description, options, machine, cuda);
    BodyState state = gpu->state();
    for (std::size_t i = 0; i < state.positions_mm.size(); ++i)
        if (gpu->body().fixed[i] == 0)
            state.velocities_mm_per_s[i] = Vec3(0, 0, 2.0 * state.positions_mm[i].x());
    gpu->set_state(state);
    const std::size_t before = machine->traffic().kernel_bytes;
    const StepReport report = gpu->advance(frame_s);
    EXPECT_EQ(cuda.share->device, 1);
    EXPECT_GE(report.linear_solves, 2);
    EXPECT_GT(static_cast<double>(cuda.share->solves.kernel_bytes),
              0.9 * static_cast<double>(machine->traffic().kernel_bytes - before));
}

TEST(CudaBackEnd, ForgetsAToolThatIsTakenAway) {
    TouchingBody body = touching_body("probe");
    const auto options = options_of(LinearSolverKind::block_jacobi, Precision::double_precision);
    const gpu::CudaOptions cuda{.precision = Precision::double_precision};
    const auto gpu = gpu::make_cuda_back_end(body.description, options, gpu::make_emulator(), cuda);
    gpu->set_tool(body.tool);
    StepReport report;
    for (int k = 0; k < 40; ++k) {
        lead(body, *gpu, frame_s);
        report = gpu->advance(frame_s);
    }
    ASSERT_GT(report.energy.contact, 0.0);
    gpu->set_tool(std::nullopt);
    const long made = cuda.share->device;
    EXPECT_EQ(gpu->advance(frame_s).energy.contact, 0.0);
    EXPECT_EQ(cuda.share->device, made + 1);
}

std::string name_of(const testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Gpu, Contact,
                         testing::Values("probe", "rod", "forceps", "hook", "obstacle", "self",
                                         "self-friction", "everything"),
                         name_of);

}  // namespace
}  // namespace hepatica
