// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/tear_study.h"

#include <algorithm>
#include <cmath>

#include "core/base/frame_time.h"
#include "core/base/median.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/mesh/brick_mesh.h"
#include "core/study/job_within.h"
#include "core/study/timing.h"
#include "core/study/vessel_body.h"
#include "core/tear/tearing.h"

namespace hepatica {
namespace {

const Vec3 size_mm(20.0, 4.0, 4.0);
constexpr double way_mm = 10.0;
constexpr double hand_un_per_mm = 2e6;  // of all springs of the pulled end together

const char* name_of(TearStop stop) {
    return stop == TearStop::none ? "none" : stop == TearStop::entropy ? "entropy" : "vertices";
}

BodyDescription bar(double edge_mm, const TearLaw& law) {
    BodyDescription body;
    Index3 cells{};
    for (int i = 0; i < 3; ++i)
        cells[i] = std::max(2, static_cast<int>(std::lround(size_mm[i] / edge_mm)));
    body.mesh = kuhn_brick(size_mm, cells);
    for (const Vec3& x : body.mesh.vertices_mm) body.fixed.push_back(x.x() < 1e-9 ? 1 : 0);
    body.tear = law;
    return body;
}

std::vector<Grab> hand_at(const BodyDescription& body, double pulled_mm) {
    std::vector<Grab> grabs;
    for (std::size_t v = 0; v < body.mesh.vertices_mm.size(); ++v) {
        if (body.mesh.vertices_mm[v].x() < size_mm.x() - 1e-9) continue;
        Grab grab;
        grab.vertices[0] = static_cast<int>(v);
        grab.target_mm = body.mesh.vertices_mm[v] + Vec3(pulled_mm, 0, 0);
        grab.force_limit_un = 1e12;
        grabs.push_back(grab);
    }
    for (Grab& grab : grabs)
        grab.stiffness_un_per_mm = hand_un_per_mm / static_cast<double>(grabs.size());
    return grabs;
}

double force_of(const std::vector<Grab>& grabs, const Stepper& stepper) {
    Vec3 sum = Vec3::Zero();
    for (const Grab& grab : grabs)
        sum +=
            grab.stiffness_un_per_mm * (grab.target_mm - stepper.positions_mm()[grab.vertices[0]]);
    return sum.norm();
}

double opened_mm2(const Tearing& tearing, const TearLaw& law) {
    double opened = 0.0;
    const TearState state = tearing.state();
    for (std::size_t i = 0; i < state.parted.size(); ++i) {
        const Joint& joint = tearing.topology().joints()[state.parted[i]];
        for (int k = 0; k < 3; ++k) {
            const auto sides = tearing.topology().sides(joint, k);
            if (sides[0] != sides[1] && state.most_mm[3 * i + k] >= law.softening().opening_mm)
                opened += joint.area_mm2 / 3.0;
        }
    }
    return opened;
}

}  // namespace

TornBar tear_bar(double edge_mm, const TearLaw& law, double step_mm, const StepperOptions& options,
                 const Job& job) {
    const BodyDescription body = bar(edge_mm, law);
    const auto stepper = make_cpu_stepper(body, options);
    const double middle = 0.5 * size_mm.x() + 0.01;
    stepper->cut(Vec3(middle, -1.0, -1.0), Vec3(0, size_mm.y() + 2.0, 0),
                 Vec3(0, 0, 1.0 + 0.25 * size_mm.z() + 0.01));
    const int cut = stepper->tearing()->report().vertices_split;
    TornBar torn{.row = {.law = law.bare_limit ? "bare limit" : "fracture energy",
                         .stop = name_of(law.stop),
                         .tear_factor = law.tear_factor,
                         .edge_mm = edge_mm,
                         .tetrahedra = static_cast<int>(body.mesh.tetrahedra.size())}};
    TearRow& row = torn.row;
    std::vector<double> step_ms, cost_ms;
    TearReport last;
    for (double pulled = step_mm; pulled < way_mm; pulled += step_mm) {
        job.throw_if_cancelled();
        const std::vector<Grab> grabs = hand_at(body, pulled);
        stepper->set_grabs(grabs);
        const FrameTimer timer;
        const StepReport report = stepper->step(frame_s, job.stop_token());
        const FrameTime time = timer.passed();
        step_ms.push_back(time.wall_ms);
        cost_ms.push_back(time.cost_ms());
        torn.iterations += report.linear_iterations;
        row.work_nj += report.energy.tear_loss;
        last = report.tear;
        row.samples.push_back(
            {pulled, force_of(grabs, *stepper), last.entropy_nats, last.entropy_produced_nats});
        row.force_max_un = std::max(row.force_max_un, row.samples.back().force_un);
        row.entropy_produced_max_nats =
            std::max(row.entropy_produced_max_nats, last.entropy_produced_nats);
    }
    row.opened_mm2 = opened_mm2(*stepper->tearing(), law);
    row.vertices_split = last.vertices_split - cut;
    row.pieces = last.pieces;
    row.median_step_ms = median(std::move(step_ms));
    torn.frame_ms = quantile(std::move(cost_ms), 0.95);
    torn.iterations /= static_cast<double>(row.samples.size()) * options.substeps;
    return torn;
}

std::vector<TearRow> study_tear(const TearStudyOptions& options, Job& job) {
    std::vector<TearRow> rows;
    std::vector<std::pair<double, TearLaw>> runs;
    TearLaw law{.strength_pa = options.strength_pa,
                .fracture_energy_j_m2 = options.fracture_energy_j_m2,
                .entropy_budget_nats = options.entropy_budget_nats,
                .vertex_budget = options.vertex_budget};
    for (const bool bare : {true, false})
        for (const double edge : options.edges_mm) {
            law.bare_limit = bare;
            runs.emplace_back(edge, law);
        }
    for (const TearStop stop : {TearStop::entropy, TearStop::vertices})
        for (const double factor : options.tear_factors)
            for (const double edge : options.edges_mm) {
                TearLaw stopped = law;
                stopped.bare_limit = false;
                stopped.stop = stop;
                stopped.tear_factor = factor;
                runs.emplace_back(edge, stopped);
            }
    job.begin_stage("Tearing bars");
    for (const auto& [edge, one] : runs) {
        rows.push_back(tear_bar(edge, one, options.step_mm, {}, job).row);
        job.advance(static_cast<double>(rows.size()) / static_cast<double>(runs.size()));
    }
    return rows;
}

namespace {

constexpr std::size_t breaking_joints = 100;

std::vector<int> nearest_joints(const Tearing& tearing, const Vec3& place_mm) {
    const auto joints = tearing.topology().joints();
    std::vector<int> whole;
    for (int j = 0; j < static_cast<int>(joints.size()); ++j)
        if (!tearing.topology().parted(j)) whole.push_back(j);
    const auto distance = [&](int j) { return (joints[j].centre_mm - place_mm).squaredNorm(); };
    std::ranges::sort(whole, {}, distance);
    whole.resize(std::min(whole.size(), breaking_joints));
    return whole;
}

BreakingRow measure_breaking(int tetrahedra, int tries, const Job& job) {
    JobWithin meshing(job);
    BodyDescription body = body_of(study_tree(6, 6.0), tetrahedra, meshing.job());
    body.tether_pa_per_mm2 = 20.0;
    body.tear = TearLaw{.bare_limit = true};
    StepperOptions options;
    options.sleeping = false;
    const auto stepper = make_cpu_stepper(body, options);
    const std::vector<Vec3>& rest = body.mesh.vertices_mm;
    const int tip = furthest_vertex(body);
    int frame = 0, broken = 0;
    const auto step_ms = [&] {
        const Grab grab = led_around(tip, rest[tip], frame++);
        const FrameTimer timer;
        stepper->set_grabs(std::span(&grab, 1));
        broken = stepper->step(frame_s, job.stop_token()).tear.joints_broken;
        return timer.passed().cost_ms();
    };
    for (int k = 0; k < 5; ++k) step_ms();
    std::vector<double> awake, breaks, after, joints;
    for (int k = 0; k < tries; ++k) {
        for (int n = 0; n < 5; ++n) awake.push_back(step_ms());
        const std::size_t place = rest.size() * (2 * k + 1) / (2 * tries);
        stepper->weaken(nearest_joints(*stepper->tearing(), rest[place]), 0.0);
        const int before = broken;
        breaks.push_back(step_ms());
        joints.push_back(broken - before);
        after.push_back(step_ms());
    }
    return {static_cast<int>(body.mesh.tetrahedra.size()), quantile(joints, 0.5),
            quantile(awake, 0.5), quantile(breaks, 0.5), quantile(after, 0.5)};
}

}  // namespace

std::vector<BreakingRow> study_breaking(const std::vector<int>& tetrahedra, int tries, Job& job) {
    std::vector<BreakingRow> rows;
    job.begin_stage("Breaking joints");
    for (const int size : tetrahedra) {
        rows.push_back(measure_breaking(size, tries, job));
        job.advance(static_cast<double>(rows.size()) / static_cast<double>(tetrahedra.size()));
    }
    return rows;
}

}  // namespace hepatica
