// SPDX-License-Identifier: GPL-3.0-or-later
// bench peers: the clamped beam of docs/solver.md in this program and in Bullet, side by side, with
// the same mesh, material, time step and gravity, from the straight shape to rest.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "app/peers/bullet_world.h"
#include "app/verbs/verbs.h"
#include "core/base/parallel.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/mesh/brick_mesh.h"
#include "core/study/timing.h"

namespace hepatica {

namespace {

struct Beam {
    Index3 cells;
    double same_mesh_fem_mm;  // deflection of the tip by CalculiX, linear tetrahedra, large
                              // deformation
};

constexpr std::array<Beam, 3> beams{
    {{{20, 3, 3}, 10.811}, {{35, 7, 7}, 13.759}, {{60, 12, 12}, 14.534}}};
constexpr double beam_length_mm = 200.0;
constexpr double dt_s = 0.01;
constexpr int steps_per_turn = 10;

struct PeerOptions {
    int steps = 200;
    int largest = 10290;
    int threads = 2;
    double energy_tolerance = 1e-2;
    std::string solver = "automatic";
};

BodyDescription beam_body(const Beam& beam) {
    BodyDescription body;
    body.mesh = kuhn_brick(Vec3(beam_length_mm, 40.0, 40.0), beam.cells);
    body.material = {
        .young_modulus_pa = 1e6, .poisson_ratio = 0.3, .density_g_mm3 = 1e-3, .damping_ratio = 0.0};
    for (const Vec3& x : body.mesh.vertices_mm) body.fixed.push_back(x.x() < 1e-9 ? 1 : 0);
    const SkeletonPolyline line{
        {Vec3(0.0, 20.0, 20.0), Vec3(beam_length_mm, 20.0, 20.0)}, {20.0, 20.0}, -1};
    body.skeleton = resample(std::span(&line, 1));
    return body;
}

// Mean deflection of the free face.
double sag_mm(const BodyDescription& body, std::span<const Vec3> positions_mm) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t v = 0; v < positions_mm.size(); ++v) {
        if (body.mesh.vertices_mm[v].x() < beam_length_mm - 1e-6) continue;
        sum += body.mesh.vertices_mm[v].z() - positions_mm[v].z();
        ++count;
    }
    return sum / count;
}

// The beam in this program, stepped with this many threads.
struct Ours {
    std::unique_ptr<Stepper> stepper;
    int threads;
    std::vector<double> ms;
    int iterations = 0;
    double energy_error = 0.0;

    void step(const std::stop_token& stop) {
        const ThreadLimit limit(threads);
        StepReport report;
        ms.push_back(timed_ms([&] { report = stepper->step(dt_s, stop); }));
        iterations += report.linear_iterations;
        energy_error = std::max(energy_error, report.linear_energy_error);
    }
};

// Runs some steps of each in turn, so that disturbances affect all alike, and none always finds its
// caches emptied by another.
Json measure(const Beam& beam, const PeerOptions& options, Job& job) {
    const BodyDescription body = beam_body(beam);
    const Vec3 gravity(0.0, 0.0, -9810.0);
    StepperOptions ours_options;
    ours_options.solver = linear_solver_kind(options.solver);
    ours_options.linear.energy_tolerance = options.energy_tolerance;
    ours_options.sleeping = false;
    std::vector<Ours> ours;
    for (const int threads : {1, options.threads}) {
        ours.push_back({make_cpu_stepper(body, ours_options), threads, {}});
        ours.back().stepper->set_gravity(gravity);
    }
    BulletWorld peer(gravity);
    peer.add_body(body.mesh, body.fixed, body.material);
    std::vector<double> peer_ms;
    for (int first = 0; first < options.steps; first += steps_per_turn) {
        job.advance(static_cast<double>(first) / options.steps);
        const int steps = std::min(steps_per_turn, options.steps - first);
        for (Ours& run : ours)
            for (int k = 0; k < steps; ++k) run.step(job.stop_token());
        for (int k = 0; k < steps; ++k) peer_ms.push_back(timed_ms([&] { peer.step(dt_s); }));
    }
    const double our_tip = sag_mm(body, ours[0].stepper->positions_mm());
    const double peer_tip = sag_mm(body, peer.positions_mm(0));
    const double single_ms = quantile(ours[0].ms, 0.5), our_ms = quantile(ours[1].ms, 0.5);
    return {{"peer", "Bullet deformable, corotational"},
            {"tetrahedra", body.mesh.tetrahedra.size()},
            {"our_threads", options.threads},
            {"our_ms", our_ms},
            {"our_one_thread_ms", single_ms},
            {"peer_threads", 1},
            {"peer_ms", quantile(peer_ms, 0.5)},
            {"time_ratio", quantile(peer_ms, 0.5) / our_ms},
            {"time_ratio_one_thread", quantile(peer_ms, 0.5) / single_ms},
            {"our_error", our_tip / beam.same_mesh_fem_mm - 1.0},
            {"peer_error", peer_tip / beam.same_mesh_fem_mm - 1.0},
            {"our_tip_mm", our_tip},
            {"peer_tip_mm", peer_tip},
            {"fem_tip_mm", beam.same_mesh_fem_mm},
            {"our_linear_energy_error", ours[0].energy_error},
            {"our_iterations_per_step", static_cast<double>(ours[0].iterations) / options.steps}};
}

}  // namespace

void add_bench_peers(CommandLine& line) {
    const auto options = std::make_shared<PeerOptions>();
    CLI::App& verb = line.add_verb(
        "bench", "Benchmarks", "peers", "The same clamped beam in this program and in Bullet",
        [options](Job& job) {
            Json rows = Json::array();
            for (const Beam& beam : beams) {
                const int tetrahedra = 6 * beam.cells[0] * beam.cells[1] * beam.cells[2];
                if (tetrahedra > options->largest) continue;
                job.begin_stage(std::to_string(tetrahedra) + " tetrahedra");
                rows.push_back(measure(beam, *options, job));
            }
            return Json{{"rows", rows}};
        });
    verb.add_option("--steps", options->steps, "Steps of 0.01 s, from straight to rest")
        ->check(CLI::Range(1, 100000));
    verb.add_option("--largest", options->largest,
                    "Leave out beams of more tetrahedra (1080, 10290, 51840)")
        ->check(CLI::Range(1080, 1'000'000));
    verb.add_option("--threads", options->threads, "Of ours; Bullet's deformable world has one")
        ->check(CLI::Range(1, 256));
    verb.add_option("--energy-tolerance", options->energy_tolerance,
                    "Of our linear solves; Bullet's own stays as it ships")
        ->check(CLI::Range(1e-12, 0.5));
    verb.add_option("--solver", options->solver, "Our linear solver");
}

}  // namespace hepatica
