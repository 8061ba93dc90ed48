// SPDX-License-Identifier: GPL-3.0-or-later
// Tears on the GPU's back end against the CPU's: single steps from the same state while joints part
// and soften, what they take, and the same bits in any order of blocks.
#include <gtest/gtest.h>

#include <optional>
#include <sstream>

#include "core/base/frame_time.h"
#include "core/deform/stepper/cpu_back_end.h"
#include "core/deform/stepper/governed_stepper.h"
#include "core/mesh/brick_mesh.h"
#include "core/tear/tearing.h"
#include "gpu/cuda_back_end.h"
#include "tests/deform/support/random_field.h"
#include "tests/gpu/support/gpu_bodies.h"

namespace hepatica {
namespace {

using gpu::BlockOrder;
using gpu::Precision;
using test::difference;
using test::relative_distance;

// A bar that is clamped at one end and pulled at the other until it tears from a cut line on
// ("notch"), or cut between two layers that are pulled off each other ("peel").
struct Play {
    bool peel = false;
};

BodyDescription body_of(const Play& play) {
    BodyDescription body;
    body.mesh = kuhn_brick(Vec3(20, 4, 4), {10, 2, 2});
    // So that no two joints bear the same.
    const auto aside = test::random_field(body.mesh.vertices_mm.size(), 0.1, 11);
    for (std::size_t v = 0; v < aside.size(); ++v)
        for (int c = 0; c < 3; ++c) {
            double& x = body.mesh.vertices_mm[v][c];
            if (x > 1e-9 && x < (c == 0 ? 20.0 : 4.0) - 1e-9) x += aside[v][c];
        }
    body.material.young_modulus_pa = 0.5e6;
    body.material.poisson_ratio = 0.3;
    for (const Vec3& x : body.mesh.vertices_mm)
        body.fixed.push_back(play.peel ? (x.x() > 20.0 - 1e-9 ? 1 : 0) : (x.x() < 1e-9 ? 1 : 0));
    body.tear = TearLaw{.strength_pa = 2e4, .fracture_energy_j_m2 = 20.0};
    return body;
}

std::vector<int> first_cut(const Play& play, const Tearing& tearing, std::span<const Vec3> x) {
    return play.peel ? tearing.crossing(Vec3(-1, -1, 2.0), Vec3(7, 0, 0), Vec3(0, 6, 0), x)
                     : tearing.crossing(Vec3(9.0, -1, -1), Vec3(0, 6, 0), Vec3(0, 0, 2.5), x);
}

std::vector<Grab> pull_of(const Play& play, const BodyDescription& body, double by_mm) {
    std::vector<Grab> grabs;
    for (std::size_t v = 0; v < body.mesh.vertices_mm.size(); ++v) {
        const Vec3& x = body.mesh.vertices_mm[v];
        const bool above = x.z() > 4.0 - 1e-9, below = x.z() < 1e-9;
        if (play.peel ? !(x.x() < 1e-9 && (above || below)) : !(x.x() > 20.0 - 1e-9)) continue;
        Grab& grab = grabs.emplace_back();
        grab.vertices[0] = static_cast<int>(v);
        grab.target_mm = x + by_mm * (play.peel ? Vec3(0, 0, above ? 1 : -1) : Vec3(1, 0.2, 0));
        grab.stiffness_un_per_mm = 1e6;
        grab.force_limit_un = 1e12;
    }
    return grabs;
}

StepperOptions tear_options(LinearSolverKind solver, Precision precision) {
    StepperOptions options = test::exact_options("corotated");
    options.solver = solver;
    options.tension = false;
    if (precision == Precision::single_precision) options.linear.residual_tolerance = 1e-6;
    return options;
}

// What parts is decided by the loads in the first back end; all of them follow.
struct Torn {
    explicit Torn(const Play& which) : play(which) {}

    Play play;
    BodyDescription body = body_of(play);
    Tearing tearing{body.mesh, *body.tear, {}};
    std::vector<std::unique_ptr<StepBackEnd>> back_ends;
    double pulled_mm = 0.0;
    int splits = 0;

    void follow() {
        for (const auto& one : back_ends) one->tear(body, torn_body_of(tearing));
    }
    void cut() {
        tearing.cut(first_cut(play, tearing, back_ends[0]->state().positions_mm));
        follow();
    }
    void pull_on() {
        pulled_mm += 0.1;
        for (const auto& one : back_ends) one->set_grabs(pull_of(play, body, pulled_mm));
    }
    bool part() {
        std::vector<Mat3> stress;
        std::vector<double> energy;
        tearing.take_openings(back_ends[0]->ties());
        back_ends[0]->find_stress(stress, energy);
        const TearLoads loads{stress, energy, back_ends[0]->state().positions_mm,
                              back_ends[0]->body().mass_g};
        tearing.measure(loads);
        if (!tearing.part_overloaded(loads)) return false;
        ++splits;
        follow();
        return true;
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

double difference_of_books(const EnergyLedger& a, const EnergyLedger& b) {
    double most = 0.0;
    for (const double d :
         {a.kinetic - b.kinetic, a.elastic - b.elastic, a.grab - b.grab, a.cohesion - b.cohesion,
          a.tear_loss - b.tear_loss, a.damping_loss - b.damping_loss,
          a.integrator_loss - b.integrator_loss, a.nonlinear_loss - b.nonlinear_loss, a.imbalance})
        most = std::max(most, std::abs(d));
    return most / energy_handled(b);
}

class DeviceTear : public testing::TestWithParam<Play> {
  protected:
    static void record(const std::string& what, double value) {
        std::ostringstream words;
        words << value;
        RecordProperty(what, words.str());
    }
    static Difference difference_over(const Play& which, Precision precision, int steps) {
        Torn torn(which);
        const gpu::CudaOptions cuda{.precision = precision};
        torn.back_ends.push_back(make_cpu_back_end(
            torn.body, tear_options(LinearSolverKind::cholesky, Precision::double_precision)));
        torn.back_ends.push_back(gpu::make_cuda_back_end(
            torn.body, tear_options(LinearSolverKind::block_jacobi, precision),
            gpu::make_emulator(), cuda));
        torn.cut();
        StepBackEnd &cpu = *torn.back_ends[0], &gpu = *torn.back_ends[1];
        Difference most;
        for (int k = 0; k < steps; ++k) {
            torn.pull_on();
            torn.even_out();
            const BodyState start = cpu.state();
            const long made = cuda.share->device;
            const StepReport expected = cpu.advance(frame_s), report = gpu.advance(frame_s);
            const bool comparable = expected.newton_iterations == 1 && !expected.shortened;
            if (cuda.share->device > made && comparable && !torn.tearing.bound_pairs().empty()) {
                ++most.steps;
                const auto moved = [&](const StepBackEnd& one) {
                    return difference(one.state().positions_mm, start.positions_mm);
                };
                most.motion = std::max(most.motion, relative_distance(moved(gpu), moved(cpu)));
                most.books =
                    std::max(most.books, difference_of_books(report.energy, expected.energy));
                for (std::size_t t = 0; t < cpu.ties().size(); ++t)
                    most.openings = std::max(
                        most.openings, std::abs(gpu.ties()[t].most_mm - cpu.ties()[t].most_mm));
                most.cohesion = std::max(most.cohesion, expected.energy.cohesion);
                most.loss = std::max(most.loss, expected.energy.tear_loss);
            }
            torn.part();
        }
        EXPECT_GT(torn.splits, 3);
        record("motion", most.motion);
        record("books", most.books);
        record("openings", most.openings);
        return most;
    }
};

TEST_P(DeviceTear, StepsAgreeInDouble) {
    const Difference found = difference_over(GetParam(), Precision::double_precision, 60);
    EXPECT_GT(found.steps, 10);
    EXPECT_LT(found.motion, 1e-10);
    EXPECT_LT(found.books, 1e-10);
    EXPECT_LT(found.openings, 1e-10);
    EXPECT_GT(found.cohesion, 0.0);
    EXPECT_GT(found.loss, 0.0);
}

TEST_P(DeviceTear, StepsAgreeInFloat) {
    const Difference found = difference_over(GetParam(), Precision::single_precision, 60);
    EXPECT_GT(found.steps, 10);
    EXPECT_LT(found.motion, 1e-4);
    EXPECT_LT(found.books, 1e-4);
    EXPECT_LT(found.openings, 1e-4);
}

TEST_P(DeviceTear, AnyOrderOfBlocksGivesTheSameBits) {
    StepperOptions quick = tear_options(LinearSolverKind::automatic, Precision::single_precision);
    quick.linear = {.max_iterations = 200};
    std::vector<BodyState> ends;
    for (const BlockOrder order : {BlockOrder::ascending, BlockOrder::descending,
                                   BlockOrder::shuffled, BlockOrder::ascending}) {
        Torn torn(GetParam());
        const gpu::CudaOptions cuda;
        torn.back_ends.push_back(
            gpu::make_cuda_back_end(torn.body, quick, gpu::make_emulator(order), cuda));
        torn.cut();
        for (int k = 0; k < 20; ++k) {
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

// A device that has followed every split goes on to the bit as one that was told of all of them at
// once.
TEST_P(DeviceTear, FollowsSplitsAsOneThatIsMadeAnew) {
    StepperOptions options = tear_options(LinearSolverKind::automatic, Precision::single_precision);
    options.linear = {.max_iterations = 200};
    Torn torn(GetParam());
    torn.back_ends.push_back(gpu::make_cuda_back_end(torn.body, options, gpu::make_emulator(), {}));
    torn.cut();
    int compared = 0;
    for (int k = 0; k < 40; ++k) {
        torn.pull_on();
        torn.back_ends[0]->advance(frame_s);
        if (!torn.part() || torn.splits % 2 != 0) continue;
        const auto anew = gpu::make_cuda_back_end(torn.body, options, gpu::make_emulator(), {});
        anew->tear(torn.body, torn_body_of(torn.tearing));
        anew->set_grabs(pull_of(torn.play, torn.body, torn.pulled_mm));
        anew->set_state(torn.back_ends[0]->state());
        torn.back_ends[0]->set_state(torn.back_ends[0]->state());
        anew->advance(frame_s);
        torn.back_ends[0]->advance(frame_s);
        EXPECT_EQ(anew->state().positions_mm, torn.back_ends[0]->state().positions_mm);
        ++compared;
    }
    EXPECT_GT(compared, 1);
}

// Each back end with a tear of its own: where it goes, what it takes and where its entropy stops
// it. Not for longer: what tears next is decided by ever smaller differences, and after some 25
// steps the CPU's own two solvers tear a peeled body in different places.
TEST_P(DeviceTear, TheEntropyStopsTheSame) {
    struct End {
        int steps_before_stop = 0;
        double produced_nats = 0.0;  // at the stop
        TearReport tear;
        EnergyLedger energy;
        std::vector<std::array<int, 4>> tetrahedra;
    };
    BodyDescription body = body_of(GetParam());
    body.tear->stop = TearStop::entropy;
    body.tear->entropy_budget_nats = GetParam().peel ? 1.0 : 0.1;
    const auto tear_until_stopped = [&](LinearSolverKind solver,
                                        const GovernedStepper::MakeBackEnd& make) {
        const StepperOptions options = tear_options(solver, Precision::double_precision);
        GovernedStepper stepper(body, options, std::nullopt, make);
        const Tearing whole(body.mesh, *body.tear, {});
        stepper.weaken(first_cut(GetParam(), whole, body.mesh.vertices_mm), 0.1);
        End end;
        for (int k = 0; k < 40; ++k) {
            stepper.set_grabs(pull_of(GetParam(), body, 0.1 * k));
            const StepReport report = stepper.step(frame_s);
            if (!report.tear.stopped) ++end.steps_before_stop;
            if (!end.tear.stopped) end.produced_nats = report.tear.entropy_produced_nats;
            end.tear = report.tear;
            end.energy = report.energy;
        }
        const auto corners = stepper.tearing()->topology().tetrahedra();
        end.tetrahedra = {corners.begin(), corners.end()};
        return end;
    };
    const gpu::CudaOptions cuda{.precision = Precision::double_precision};
    const End expected = tear_until_stopped(LinearSolverKind::cholesky, make_cpu_back_end);
    const End found = tear_until_stopped(
        LinearSolverKind::block_jacobi,
        [&](const BodyDescription& description, const StepperOptions& options) {
            return gpu::make_cuda_back_end(description, options, gpu::make_emulator(), cuda);
        });
    EXPECT_TRUE(expected.tear.stopped);
    EXPECT_TRUE(found.tear.stopped);
    EXPECT_GT(expected.tear.vertices_split, 15);
    EXPECT_GT(cuda.share->device, 10);
    EXPECT_EQ(found.steps_before_stop, expected.steps_before_stop);
    EXPECT_GT(expected.produced_nats, body.tear->entropy_budget_nats);
    EXPECT_NEAR(found.produced_nats, expected.produced_nats, 1e-8);
    EXPECT_EQ(found.tetrahedra, expected.tetrahedra);
    EXPECT_EQ(found.tear.joints_broken, expected.tear.joints_broken);
    EXPECT_NEAR(found.tear.entropy_produced_nats, expected.tear.entropy_produced_nats, 1e-8);
    EXPECT_LT(difference_of_books(found.energy, expected.energy), 1e-8);
}

// A torn body that goes on from a checkpoint, on a device that never saw it whole.
TEST_P(DeviceTear, ContinuesFromACheckpointToTheBit) {
    const BodyDescription body = body_of(GetParam());
    const auto make = [&] {
        return GovernedStepper(body, {}, std::nullopt,
                               [](const BodyDescription& whole, const StepperOptions& options) {
                                   return gpu::make_cuda_back_end(whole, options,
                                                                  gpu::make_emulator(), {});
                               });
    };
    GovernedStepper one = make(), other = make();
    one.weaken(first_cut(GetParam(), Tearing(body.mesh, *body.tear, {}), body.mesh.vertices_mm),
               0.1);
    for (int k = 1; k <= 6; ++k) {
        one.set_grabs(pull_of(GetParam(), body, 0.1 * k));
        one.step(frame_s);
    }
    EXPECT_GT(one.tearing()->report().vertices_split, 3);
    other.restore(one.checkpoint());
    EXPECT_EQ(one.state_hash(), other.state_hash());
    for (int k = 0; k < 3; ++k) {
        one.step(frame_s);
        other.step(frame_s);
        EXPECT_EQ(one.state_hash(), other.state_hash());
    }
}

// The hand held a vertex that vanishes: nothing pulls the whole body any more.
TEST_P(DeviceTear, ForgetsTheHandOnAVertexThatIsTakenBack) {
    const BodyDescription body = body_of(GetParam());
    GovernedStepper stepper(
        body, {}, std::nullopt, [](const BodyDescription& whole, const StepperOptions& options) {
            return gpu::make_cuda_back_end(whole, options, gpu::make_emulator(), {});
        });
    stepper.step(frame_s);
    const StepperCheckpoint whole = stepper.checkpoint();
    stepper.cut(Vec3(10.3, -1, -1), Vec3(0, 8, 0), Vec3(0, 0, 8));
    const int last = static_cast<int>(stepper.positions_mm().size()) - 1;
    ASSERT_GE(last, static_cast<int>(body.mesh.vertices_mm.size()));
    Grab grab{.vertices = {last, -1, -1, -1}};
    grab.target_mm = stepper.positions_mm()[last] + Vec3(0, 0, 1);
    grab.stiffness_un_per_mm = 1e4;
    grab.force_limit_un = 1e6;
    stepper.set_grabs({&grab, 1});
    stepper.step(frame_s);
    stepper.restore(whole);
    const std::vector<Vec3> before(stepper.positions_mm().begin(), stepper.positions_mm().end());
    EXPECT_EQ(stepper.step(frame_s).energy.grab, 0.0);
    for (std::size_t v = 0; v < before.size(); ++v)
        EXPECT_LT((stepper.positions_mm()[v] - before[v]).norm(), 1e-3) << v;
}

std::string name_of_play(const testing::TestParamInfo<Play>& play) {
    return play.param.peel ? "peel" : "notch";
}
INSTANTIATE_TEST_SUITE_P(Gpu, DeviceTear, testing::Values(Play{false}, Play{true}), name_of_play);

// Of a body of many elements a split changes few places in the lists; what grows at the end moves
// others. Elements at rest, most of what there is, are not copied again.
TEST(DeviceTearCopies, OnlyWhatASplitChanges) {
    BodyDescription body = body_of({});
    body.mesh = kuhn_brick(Vec3(60, 12, 12), {30, 6, 6});
    body.fixed.assign(body.mesh.vertices_mm.size(), 0);
    const std::shared_ptr<gpu::Machine> machine = gpu::make_emulator();
    const auto device = gpu::make_cuda_back_end(
        body, tear_options(LinearSolverKind::block_jacobi, Precision::single_precision), machine,
        {});
    const std::size_t made = machine->traffic().copied_bytes;
    Tearing tearing(body.mesh, *body.tear, {});
    const auto copied_by_a_cut = [&](double x_mm) {
        tearing.cut(tearing.crossing(Vec3(x_mm, -1, 11.0), Vec3(0, 3, 0), Vec3(0, 0, 2),
                                     body.mesh.vertices_mm));
        const std::size_t before = machine->traffic().copied_bytes;
        device->tear(body, torn_body_of(tearing));
        return machine->traffic().copied_bytes - before;
    };
    EXPECT_LT(copied_by_a_cut(51.0), made);  // where lists grow memory is taken anew
    EXPECT_LT(copied_by_a_cut(55.0), made / 3);
}

}  // namespace
}  // namespace hepatica
