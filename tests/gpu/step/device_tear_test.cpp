// SPDX-License-Identifier: GPL-3.0-or-later
// Tears on the GPU's back end against the CPU's: single steps from the same state while joints part
// and soften, what they take, and the same bits in any order of blocks.
#include <gtest/gtest.h>

#include <optional>

#include "core/base/frame_time.h"
#include "core/deform/stepper/cpu_back_end.h"
#include "core/mesh/brick_mesh.h"
#include "core/tear/tearing.h"
#include "gpu/cuda_back_end.h"
#include "tests/gpu/support/gpu_bodies.h"

namespace hepatica {
namespace {

using gpu::BlockOrder;
using gpu::Precision;
using test::difference;
using test::relative_distance;

// A bar with a notch, clamped at one end.
BodyDescription bar_that_tears() {
    BodyDescription body;
    body.mesh = kuhn_brick(Vec3(20, 4, 4), {10, 2, 2});
    body.material.young_modulus_pa = 0.5e6;
    body.material.poisson_ratio = 0.3;
    for (const Vec3& x : body.mesh.vertices_mm) body.fixed.push_back(x.x() < 1e-9 ? 1 : 0);
    body.tear = TearLaw{.strength_pa = 2e4, .fracture_energy_j_m2 = 20.0};
    return body;
}

std::vector<Grab> pull_of(const BodyDescription& body, double by_mm) {
    std::vector<Grab> grabs;
    for (std::size_t v = 0; v < body.mesh.vertices_mm.size(); ++v)
        if (body.mesh.vertices_mm[v].x() > 20.0 - 1e-9) {
            Grab& grab = grabs.emplace_back();
            grab.vertices[0] = static_cast<int>(v);
            grab.target_mm = body.mesh.vertices_mm[v] + Vec3(by_mm, 0.2 * by_mm, 0);
            grab.stiffness_un_per_mm = 1e6;
            grab.force_limit_un = 1e12;
        }
    return grabs;
}

StepperOptions options_of(LinearSolverKind solver, Precision precision) {
    StepperOptions options = test::exact_options("corotated");
    options.solver = solver;
    options.tension = false;
    if (precision == Precision::single_precision) options.linear.residual_tolerance = 1e-6;
    return options;
}

// What parts is decided by the loads in the first back end; all of them follow.
struct Torn {
    BodyDescription body = bar_that_tears();
    Tearing tearing{body.mesh, *body.tear, {}};
    std::vector<std::unique_ptr<StepBackEnd>> back_ends;
    double pulled_mm = 0.0;
    int splits = 0;

    void follow() {
        for (const auto& one : back_ends) one->tear(body, torn_body_of(tearing));
    }
    void notch() {
        tearing.cut(tearing.crossing(Vec3(9.0, -1, -1), Vec3(0, 6, 0), Vec3(0, 0, 2.5),
                                     back_ends[0]->state().positions_mm));
        follow();
    }
    void pull_on() {
        pulled_mm += 0.1;
        for (const auto& one : back_ends) one->set_grabs(pull_of(body, pulled_mm));
    }
    void part() {
        std::vector<Mat3> stress;
        std::vector<double> energy;
        tearing.take_openings(back_ends[0]->ties());
        back_ends[0]->find_stress(stress, energy);
        const TearLoads loads{stress, energy, back_ends[0]->state().positions_mm,
                              back_ends[0]->body().mass_g};
        tearing.measure(loads);
        if (!tearing.part_overloaded(loads)) return;
        ++splits;
        follow();
    }
    // Lets the second back end go on from the state and the ties of the first.
    void even_out() {
        tearing.take_openings(back_ends[0]->ties());
        follow();
        back_ends[1]->set_state(back_ends[0]->state());
    }
};

struct Difference {
    double motion = 0.0, books = 0.0, openings = 0.0;
    int steps = 0;                      // that the device made while ties held
    double cohesion = 0.0, loss = 0.0;  // the most that was seen
};

Difference play(Precision precision, int steps) {
    Torn torn;
    const gpu::CudaOptions cuda{.precision = precision};
    torn.back_ends.push_back(make_cpu_back_end(
        torn.body, options_of(LinearSolverKind::cholesky, Precision::double_precision)));
    torn.back_ends.push_back(
        gpu::make_cuda_back_end(torn.body, options_of(LinearSolverKind::block_jacobi, precision),
                                gpu::make_emulator(), cuda));
    torn.notch();
    StepBackEnd &cpu = *torn.back_ends[0], &gpu = *torn.back_ends[1];
    Difference most;
    for (int k = 0; k < steps; ++k) {
        torn.pull_on();
        torn.even_out();
        const BodyState start = cpu.state();
        const long made = cuda.share->device;
        const StepReport expected = cpu.advance(frame_s), report = gpu.advance(frame_s);
        const bool held = !torn.tearing.bound_pairs().empty();
        if (cuda.share->device > made && held) {
            ++most.steps;
            const auto moved = [&](const StepBackEnd& one) {
                return difference(one.state().positions_mm, start.positions_mm);
            };
            most.motion = std::max(most.motion, relative_distance(moved(gpu), moved(cpu)));
            const EnergyLedger &a = report.energy, &b = expected.energy;
            for (const double d :
                 {a.kinetic - b.kinetic, a.elastic - b.elastic, a.grab - b.grab,
                  a.cohesion - b.cohesion, a.tear_loss - b.tear_loss,
                  a.integrator_loss - b.integrator_loss, a.nonlinear_loss - b.nonlinear_loss})
                most.books = std::max(most.books, std::abs(d) / energy_handled(b));
            for (std::size_t t = 0; t < cpu.ties().size(); ++t)
                most.openings = std::max(most.openings,
                                         std::abs(gpu.ties()[t].most_mm - cpu.ties()[t].most_mm));
            most.cohesion = std::max(most.cohesion, b.cohesion);
            most.loss = std::max(most.loss, b.tear_loss);
        }
        torn.part();
    }
    EXPECT_GT(torn.splits, 3);
    return most;
}

TEST(DeviceTear, StepsAgreeInDouble) {
    const Difference found = play(Precision::double_precision, 60);
    EXPECT_GT(found.steps, 10);
    EXPECT_LT(found.motion, 1e-10);
    EXPECT_LT(found.books, 1e-10);
    EXPECT_LT(found.openings, 1e-10);
    EXPECT_GT(found.cohesion, 0.0);
    EXPECT_GT(found.loss, 0.0);
}

TEST(DeviceTear, StepsAgreeInFloat) {
    const Difference found = play(Precision::single_precision, 60);
    EXPECT_GT(found.steps, 10);
    EXPECT_LT(found.motion, 1e-4);
    EXPECT_LT(found.books, 1e-4);
}

TEST(DeviceTear, AnyOrderOfBlocksGivesTheSameBits) {
    std::vector<BodyState> ends;
    for (const BlockOrder order : {BlockOrder::ascending, BlockOrder::descending,
                                   BlockOrder::shuffled, BlockOrder::ascending}) {
        Torn torn;
        const gpu::CudaOptions cuda;
        torn.back_ends.push_back(gpu::make_cuda_back_end(
            torn.body, options_of(LinearSolverKind::automatic, Precision::single_precision),
            gpu::make_emulator(order), cuda));
        torn.notch();
        for (int k = 0; k < 40; ++k) {
            torn.pull_on();
            torn.back_ends[0]->advance(frame_s);
            torn.part();
        }
        EXPECT_GT(torn.splits, 3);
        EXPECT_GT(cuda.share->device, 10);
        ends.push_back(torn.back_ends[0]->state());
    }
    for (const BodyState& end : ends) {
        EXPECT_EQ(end.positions_mm, ends[0].positions_mm);
        EXPECT_EQ(end.velocities_mm_per_s, ends[0].velocities_mm_per_s);
    }
}

}  // namespace
}  // namespace hepatica
