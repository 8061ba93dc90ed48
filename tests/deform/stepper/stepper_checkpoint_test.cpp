// SPDX-License-Identifier: GPL-3.0-or-later
// A stepper that is restored from a checkpoint goes on with the bits of the one it was taken from,
// wherever it was taken and whatever was lagged, warm, asleep or frozen at that moment.
#include "core/deform/stepper/stepper_checkpoint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <set>

#include "core/base/error.h"
#include "core/base/frame_time.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/live_stepper.h"
#include "core/mesh/brick_mesh.h"
#include "tests/deform/support/test_bodies.h"

namespace hepatica {
namespace {

constexpr int last_kept_step = 160;
constexpr int steps_after = 60;

enum class Variant { plain, newton, substeps, lagged };

struct PlayedBody {
    LinearSolverKind solver;
    ElementOrder order;
    bool live;
    Variant variant;
};

// A long bar in tissue, or a short one of quadratic elements: led away, let go until it rests, held
// again.
class Motion {
  public:
    explicit Motion(const PlayedBody& c)
        : case_(c),
          body_(test::description_of(c.order == ElementOrder::linear
                                         ? test::make_bar(90.0, 3.0, 24, 1)
                                         : test::make_bar(24.0, 4.0, 6, 1))),
          tip_(test::tip_of(body_)) {
        body_.material.damping_ratio = 1.0;
        body_.tether_pa_per_mm2 = 2000.0;
    }

    std::unique_ptr<Stepper> stepper() const {
        if (!case_.live) return make_cpu_stepper(body_, options(0));
        return make_live_stepper(body_, options(0),
                                 {.wake_radii = 3e-3, .still_radii_per_s = 1.5e-2});
    }

    // Those that hold in step k: E of eq. (11) changes in mid-pull.
    StepperOptions options(int k) const {
        StepperOptions options;
        options.order = case_.order;
        options.solver = case_.solver;
        if (case_.variant == Variant::newton) options.newton_iterations = 3;
        if (case_.variant == Variant::substeps) options.substeps = 2;
        // Factors and preconditioners serve longest where little is asked of them.
        if (case_.variant == Variant::lagged) options.linear.energy_tolerance = 0.2;
        options.velocity_error = {.alpha_per_s = 0.1, .beta_s = k < 20 ? 1e-4 : 3e-4};
        return options;
    }

    // What happens before step k.
    void act(Stepper& stepper, int k) const {
        if (k == 20) stepper.set_options(options(k));
        if (k < 40) hold(stepper, tip_, 0.03 * k);
        if (k == 40) stepper.set_grabs({});
        if (k >= 150) hold(stepper, tip_ / 2, 0.03 * (k - 149));
    }

  private:
    void hold(Stepper& stepper, int vertex, double pull_mm) const {
        Grab grab{.vertices = {vertex, -1, -1, -1}};
        grab.target_mm = body_.mesh.vertices_mm[vertex] + Vec3(0.0, pull_mm, 0.5 * pull_mm);
        grab.stiffness_un_per_mm = 2e4;
        grab.force_limit_un = 1e5;
        stepper.set_grabs(std::span(&grab, 1));
    }

    PlayedBody case_;
    BodyDescription body_;
    int tip_;
};

int computed(const Stepper& stepper) {
    const auto* live = dynamic_cast<const LiveStepper*>(&stepper);
    return live ? live->extent().live_elements : 0;
}

struct Played {
    std::map<int, std::string> kept;  // after these steps
    std::vector<std::uint64_t> hashes;
    std::vector<std::vector<Vec3>> positions, velocities;
    std::vector<EnergyLedger> energies;
    int asleep = 0, region_changes = 0;
};

void record(Played& run, const Stepper& stepper, const StepReport& report) {
    run.hashes.push_back(stepper.state_hash());
    run.positions.emplace_back(stepper.positions_mm().begin(), stepper.positions_mm().end());
    run.velocities.emplace_back(stepper.velocities_mm_per_s().begin(),
                                stepper.velocities_mm_per_s().end());
    run.energies.push_back(report.energy);
}

// Keeps checkpoints of a few steps drawn by chance, and of those that fell asleep or changed the
// region.
Played play(const Motion& motion) {
    std::mt19937 random(7);
    std::set<int> moments{0, 1, 4, 20, 40};
    for (int i = 0; i < 4; ++i) moments.insert(static_cast<int>(random() % last_kept_step));
    Played run;
    const auto stepper = motion.stepper();
    int before = computed(*stepper);
    for (int k = 0; k <= last_kept_step + steps_after; ++k) {
        motion.act(*stepper, k);
        const StepReport report = stepper->step(frame_s);
        record(run, *stepper, report);
        run.asleep += report.asleep ? 1 : 0;
        const bool changed = computed(*stepper) != std::exchange(before, computed(*stepper));
        run.region_changes += changed ? 1 : 0;
        const bool wanted = moments.contains(k) || changed || (report.asleep && run.asleep == 1);
        if (wanted && k <= last_kept_step) run.kept[k] = to_bytes(stepper->checkpoint());
    }
    return run;
}

class StepperCheckpointTest : public testing::TestWithParam<PlayedBody> {};

TEST_P(StepperCheckpointTest, ARestoredStepperGoesOnToTheLastBit) {
    const Motion motion(GetParam());
    const Played run = play(motion);
    const bool has_region = GetParam().live && GetParam().order == ElementOrder::linear;
    EXPECT_GT(run.asleep, 0);
    if (has_region) {
        EXPECT_GT(run.region_changes, 2);
    }
    for (const auto& [step, bytes] : run.kept) {
        const auto stepper = motion.stepper();
        stepper->set_options(motion.options(step));
        stepper->restore(checkpoint_from_bytes(bytes));
        ASSERT_EQ(to_bytes(stepper->checkpoint()), bytes) << "after step " << step;
        ASSERT_EQ(stepper->state_hash(), run.hashes[step]) << "after step " << step;
        Played again;
        for (int k = step + 1; k <= step + steps_after; ++k) {
            motion.act(*stepper, k);
            const StepReport report = stepper->step(frame_s);
            record(again, *stepper, report);
            ASSERT_EQ(again.positions.back(), run.positions[k]) << k << " from " << step;
            ASSERT_EQ(again.velocities.back(), run.velocities[k]) << k << " from " << step;
            ASSERT_EQ(again.hashes.back(), run.hashes[k]) << k << " from " << step;
            ASSERT_EQ(again.energies.back().elastic, run.energies[k].elastic) << k;
            ASSERT_EQ(again.energies.back().grab, run.energies[k].grab) << k;
            ASSERT_EQ(again.energies.back().tool_work, run.energies[k].tool_work) << k;
        }
    }
}

std::vector<PlayedBody> all_cases() {
    std::vector<PlayedBody> cases;
    for (const auto solver : {LinearSolverKind::block_jacobi, LinearSolverKind::skeleton,
                              LinearSolverKind::cholesky, LinearSolverKind::automatic})
        for (const auto order : {ElementOrder::linear, ElementOrder::quadratic})
            for (const bool live : {false, true})
                for (const auto variant :
                     {Variant::plain, Variant::newton, Variant::substeps, Variant::lagged})
                    cases.push_back({solver, order, live, variant});
    return cases;
}

std::string name_of_case(const testing::TestParamInfo<PlayedBody>& info) {
    const char* variants[] = {"plain", "newton", "substeps", "lagged"};
    std::string name(name_of(info.param.solver));
    std::ranges::replace(name, '-', '_');
    name += info.param.order == ElementOrder::linear ? "_linear" : "_quadratic";
    return name + (info.param.live ? "_live_" : "_cpu_") +
           variants[static_cast<int>(info.param.variant)];
}

INSTANTIATE_TEST_SUITE_P(All, StepperCheckpointTest, testing::ValuesIn(all_cases()), name_of_case);

// In the middle of a pull, half a region frozen, work of the tool unreported.
StepperCheckpoint rich_checkpoint() {
    const Motion motion({LinearSolverKind::skeleton, ElementOrder::linear, true, Variant::newton});
    const auto stepper = motion.stepper();
    for (int k = 0; k <= last_kept_step; ++k) {
        motion.act(*stepper, k);
        stepper->step(frame_s);
    }
    motion.act(*stepper, last_kept_step + 1);
    return stepper->checkpoint();
}

// Everything that is written is also read and hashed, and any of it that changes is noticed: each
// word of eight bytes in turn.
TEST(StepperCheckpointBytes, EveryWordCountsInTheHashAndInTheBytes) {
    const StepperCheckpoint checkpoint = rich_checkpoint();
    ASSERT_TRUE(checkpoint.region);
    ASSERT_TRUE(checkpoint.solver.made_from);
    EXPECT_NE(checkpoint.unreported_tool_work, 0.0);
    const std::string bytes = to_bytes(checkpoint);
    const std::uint64_t hash = hash_of(checkpoint);
    EXPECT_EQ(hash_of(checkpoint_from_bytes(bytes)), hash);
    const std::size_t heading = bytes.find('\n') + 1;
    int changed = 0;
    for (std::size_t i = heading; i + 8 <= bytes.size(); i += 8 * 7 + 1) {
        std::string other = bytes;
        other[i] = static_cast<char>(other[i] ^ 1);
        try {
            const StepperCheckpoint read = checkpoint_from_bytes(other);
            EXPECT_NE(hash_of(read), hash) << "byte " << i;
            EXPECT_EQ(to_bytes(read), other) << "byte " << i;
            ++changed;
        } catch (const InputError&) {  // a length, or a number that is not finite any more
        }
    }
    EXPECT_GT(changed, 100);
}

// Field by field, so that none can be left out of the list of fields.
TEST(StepperCheckpointBytes, EveryFieldCountsInTheHash) {
    using Change = std::function<void(StepperCheckpoint&)>;
    const std::map<std::string, Change> changes{
        {"positions", [](auto& c) { c.nodes.positions_mm[3].y() += 1e-9; }},
        {"velocities", [](auto& c) { c.nodes.velocities_mm_per_s[3].y() += 1e-9; }},
        {"grab vertex", [](auto& c) { c.grabs[0].vertices[1] = 5; }},
        {"grab weight", [](auto& c) { c.grabs[0].weights[3] += 1e-9; }},
        {"grab target", [](auto& c) { c.grabs[0].target_mm.z() += 1e-9; }},
        {"grab stiffness", [](auto& c) { c.grabs[0].stiffness_un_per_mm += 1.0; }},
        {"grab limit", [](auto& c) { c.grabs[0].force_limit_un += 1.0; }},
        {"no grabs", [](auto& c) { c.grabs.clear(); }},
        {"gravity", [](auto& c) { c.gravity_mm_per_s2.x() += 1.0; }},
        {"tool work", [](auto& c) { c.unreported_tool_work += 1.0; }},
        {"still", [](auto& c) { c.still_s += 1.0; }},
        {"settled", [](auto& c) { c.settled_s += 1.0; }},
        {"swing", [](auto& c) { c.swing_mm_per_s += 1.0; }},
        {"thin pad",
         [](auto& c) {
             c.tool.emplace().tool.thin_pads.push_back({{1, 2, 3}, 0.1});
         }},
        {"thicker pad",
         [](auto& c) {
             c.tool.emplace().tool.thin_pads.push_back({{1, 2, 3}, 0.2});
         }},
        {"origin thin pad",
         [](auto& c) {
             c.solver.tool.emplace().tool.thin_pads.push_back({{1, 2, 3}, 0.1});
         }},
        {"lying twins",
         [](auto& c) {
             c.self.emplace().overlaps.lying = {1, 2};
         }},
        {"pad of a split",
         [](auto& c) {
             c.self.emplace().overlaps.pads.push_back({{0, 1, 2, 3}, 1, 0.1, 0.2, 0.5});
         }},
        {"its share",
         [](auto& c) {
             c.self.emplace().overlaps.pads.push_back({{0, 1, 2, 3}, 1, 0.1, 0.2, 0.6});
         }},
        {"pad of a split at an obstacle",
         [](auto& c) {
             c.obstacles.emplace().touch.overlaps.pads.push_back({{0, 1, 2, 3}, 1, 0.1, 0.2, 0.5});
         }},
        {"last kinetic", [](auto& c) { c.last_kinetic += 1.0; }},
        {"last elastic", [](auto& c) { c.last_elastic += 1.0; }},
        {"last grab", [](auto& c) { c.last_grab += 1.0; }},
        {"last tether", [](auto& c) { c.last_tether += 1.0; }},
        {"memory", [](auto& c) { c.solver.memory[0] += 1.0; }},
        {"coupled numbers",
         [](auto& c) {
             c.solver.coupled.numbers = {0.0, 0.0, 1.0};
         }},
        {"coupled pairs",
         [](auto& c) {
             c.solver.coupled = {{0, 9}, {0.0, 0.0, 1.0}};
         }},
        {"no origin", [](auto& c) { c.solver.made_from.reset(); }},
        {"origin dt", [](auto& c) { c.solver.made_from->dt_s += 1e-9; }},
        {"origin start", [](auto& c) { c.solver.made_from->first_mm[0].x() += 1e-9; }},
        {"origin iterate", [](auto& c) { c.solver.made_from->iterate_mm.push_back(Vec3::Zero()); }},
        {"origin grabs", [](auto& c) { c.solver.made_from->grabs.emplace_back(); }},
        {"origin E of M", [](auto& c) { c.solver.made_from->velocity_error.alpha_per_s += 1.0; }},
        {"origin E of K", [](auto& c) { c.solver.made_from->velocity_error.beta_s += 1.0; }},
        {"live", [](auto& c) { c.region->live[0] ^= 1; }},
        {"node still", [](auto& c) { c.region->still_s[0] += 1.0; }},
        {"held", [](auto& c) { c.region->held.push_back(0); }},
        {"reference", [](auto& c) { c.region->reference_mm.emplace_back(1.0, 2.0, 3.0); }},
        {"loss", [](auto& c) { c.unreported_loss += 1.0; }},
        {"no region", [](auto& c) { c.region.reset(); }},
        {"origin collapse", [](auto& c) { c.solver.made_from->collapse ^= true; }},
        {"origin held", [](auto& c) { c.solver.made_from->held[0] ^= 1; }},
    };
    const StepperCheckpoint checkpoint = rich_checkpoint();
    std::map<std::uint64_t, std::string> seen{{hash_of(checkpoint), "nothing"}};
    for (const auto& [name, change] : changes) {
        StepperCheckpoint other = checkpoint;
        change(other);
        const auto [known, is_new] = seen.emplace(hash_of(other), name);
        EXPECT_TRUE(is_new) << name << " hashes as " << known->second;
    }
}

TEST(StepperCheckpointBytes, RefusesWhatIsNone) {
    const std::string bytes = to_bytes(rich_checkpoint());
    EXPECT_THROW(checkpoint_from_bytes(""), InputError);
    EXPECT_THROW(checkpoint_from_bytes("solid cube\n"), InputError);
    EXPECT_THROW(checkpoint_from_bytes(bytes + "x"), InputError);
    for (std::size_t size = 0; size < bytes.size(); size += 997)
        EXPECT_THROW(checkpoint_from_bytes(bytes.substr(0, size)), InputError) << size;
    StepperCheckpoint bad = rich_checkpoint();
    bad.still_s = std::numeric_limits<double>::infinity();
    EXPECT_THROW(checkpoint_from_bytes(to_bytes(bad)), InputError);
}

// Refused checkpoints leave the stepper as it was.
TEST(StepperCheckpointBytes, AStepperRefusesWhatIsNotOfItsKind) {
    using Change = std::function<void(StepperCheckpoint&)>;
    const std::map<std::string, Change> changes{
        {"fewer nodes", [](auto& c) { c.nodes.positions_mm.pop_back(); }},
        {"grab of no vertex", [](auto& c) { c.grabs[0].vertices[0] = 1 << 30; }},
        {"no region", [](auto& c) { c.region.reset(); }},
        {"fewer stretches", [](auto& c) { c.region->live.pop_back(); }},
        {"half live", [](auto& c) { c.region->live[0] = 2; }},
        {"held outside", [](auto& c) { c.region->held.push_back(-1); }},
        {"reference", [](auto& c) { c.region->reference_mm.resize(1, Vec3::Zero()); }},
        {"fewer held", [](auto& c) { c.solver.made_from->held.pop_back(); }},
        {"no memory", [](auto& c) { c.solver.memory.clear(); }},
        {"no origin", [](auto& c) { c.solver.made_from.reset(); }},
        {"time", [](auto& c) { c.solver.made_from->dt_s = 0.0; }},
        {"start", [](auto& c) { c.solver.made_from->first_mm.pop_back(); }},
    };
    const StepperCheckpoint checkpoint = rich_checkpoint();
    const Motion motion({LinearSolverKind::skeleton, ElementOrder::linear, true, Variant::newton});
    const auto stepper = motion.stepper();
    for (int k = 0; k < 10; ++k) stepper->step(frame_s);
    const std::uint64_t before = stepper->state_hash();
    for (const auto& [name, change] : changes) {
        StepperCheckpoint other = checkpoint;
        change(other);
        EXPECT_THROW(stepper->restore(other), InputError) << name;
        EXPECT_EQ(stepper->state_hash(), before) << name;
    }
    const Motion whole({LinearSolverKind::skeleton, ElementOrder::linear, false, Variant::newton});
    EXPECT_THROW(whole.stepper()->restore(checkpoint), InputError);
}

TEST(StepperCheckpoint, GoesBackBehindASplitWhoseNewVertexIsHeld) {
    BodyDescription body;
    body.mesh = kuhn_brick(Vec3(24, 6, 6), {8, 2, 2});
    body.tear = TearLaw{};
    StepperOptions options;
    options.solver = LinearSolverKind::cholesky;
    const auto stepper = make_cpu_stepper(body, options);
    stepper->step(frame_s);
    const StepperCheckpoint whole = stepper->checkpoint();
    const std::uint64_t then = stepper->state_hash();
    stepper->cut(Vec3(12.1, -1, -1), Vec3(0, 8, 0), Vec3(0, 0, 8));
    const int last = static_cast<int>(stepper->positions_mm().size()) - 1;
    ASSERT_GE(last, static_cast<int>(body.mesh.vertices_mm.size()));
    Grab grab{.vertices = {last, -1, -1, -1}};
    grab.target_mm = stepper->positions_mm()[last];
    grab.stiffness_un_per_mm = 1e4;
    grab.force_limit_un = 1e6;
    stepper->set_grabs({&grab, 1});
    stepper->step(frame_s);
    stepper->restore(whole);
    EXPECT_EQ(stepper->state_hash(), then);
    EXPECT_EQ(stepper->energies().grab, 0.0);
}

}  // namespace
}  // namespace hepatica
