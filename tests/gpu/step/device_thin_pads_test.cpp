// SPDX-License-Identifier: GPL-3.0-or-later
// Faces that a cut lays bare in a tool's pad, on the GPU's back end against the CPU's.
#include <gtest/gtest.h>

#include "core/base/frame_time.h"
#include "core/deform/stepper/cpu_back_end.h"
#include "core/deform/stepper/governed_stepper.h"
#include "core/mesh/brick_mesh.h"
#include "core/tear/tearing.h"
#include "gpu/cuda_back_end.h"
#include "tests/gpu/support/gpu_bodies.h"

namespace hepatica {
namespace {

using gpu::Precision;

// A block on its bottom, with a ball pressed onto its top, that tears only where a blade passes.
BodyDescription block() {
    BodyDescription body;
    body.mesh = kuhn_brick(Vec3(8, 8, 4), {4, 4, 2});
    for (const Vec3& x : body.mesh.vertices_mm) body.fixed.push_back(x.z() < 0.1);
    body.touchable = true;
    body.tear = TearLaw{.tear_factor = 1e3};
    return body;
}

// Where the block's vertices are after a cut below the ball and some steps behind it.
std::vector<Vec3> pressed_and_cut(Stepper& stepper) {
    Tool ball = single_tool({Vec3(4.2, 3.9, 7.0), Vec3::Zero(), 2.0});
    ball.pad_mm = 0.5;
    ball.pressure_pa = 5e3;
    stepper.set_tool(ball);
    stepper.lead_tool(Vec3(4.2, 3.9, 5.6));
    for (int k = 0; k < 30; ++k) stepper.step(frame_s);
    const double before = stepper.energies().contact;
    EXPECT_GT(before, 0.0);
    stepper.cut(Vec3(4.1, -1, 2.5), Vec3(0, 10, 0), Vec3(0, 0, 10));
    EXPECT_FALSE(stepper.tool()->thin_pads.empty());
    EXPECT_NEAR(stepper.energies().contact, before, 1e-9 * before);
    for (int k = 0; k < 10; ++k) stepper.step(frame_s);
    return {stepper.positions_mm().begin(), stepper.positions_mm().end()};
}

TEST(DeviceThinPads, HoldTheToolAsOnTheProcessor) {
    StepperOptions options = test::exact_options("corotated");
    options.tension = false;
    const gpu::CudaOptions cuda{.precision = Precision::double_precision};
    GovernedStepper processor(block(), options, std::nullopt, make_cpu_back_end);
    options.solver = LinearSolverKind::block_jacobi;
    GovernedStepper device(block(), options, std::nullopt,
                           [&](const BodyDescription& body, const StepperOptions& with) {
                               return gpu::make_cuda_back_end(body, with, gpu::make_emulator(),
                                                              cuda);
                           });
    const std::vector<Vec3> expected = pressed_and_cut(processor), found = pressed_and_cut(device);
    EXPECT_GT(cuda.share->device, 20);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t v = 0; v < found.size(); ++v)
        EXPECT_LT((found[v] - expected[v]).norm(), 1e-6) << v;
    EXPECT_EQ(device.tool()->thin_pads.size(), processor.tool()->thin_pads.size());
}

}  // namespace
}  // namespace hepatica
