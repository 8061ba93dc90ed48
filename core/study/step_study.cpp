// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/step_study.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/base/frame_time.h"
#include "core/base/hash.h"
#include "core/base/parallel.h"
#include "core/deform/body/energy_ledger.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/study/job_within.h"
#include "core/study/timing.h"
#include "core/study/vessel_body.h"

namespace hepatica {

namespace {

constexpr int frames_per_batch = 20;

// One stepper with a fixed number of threads.
struct Run {
    StepRow row;
    std::unique_ptr<Stepper> stepper;
    std::vector<double> ms;
    std::vector<double> imbalance_nj, handled_nj;  // of each step
};

std::uint64_t hash_of(const Stepper& stepper) {
    Hasher hasher;
    for (const auto& values : {stepper.positions_mm(), stepper.velocities_mm_per_s()})
        hasher.add(std::span(values.data()->data(), 3 * values.size()));
    return hasher.value();
}

void advance(Run& run, const Grab& grab, const Job& job) {
    StepReport report;
    run.ms.push_back(timed_ms([&] {
        run.stepper->set_grabs(std::span(&grab, 1));
        report = run.stepper->step(frame_s, job.stop_token());
    }));
    run.row.iterations += report.linear_iterations;
    run.row.newton_iterations += report.newton_iterations;
    run.row.energy_error = std::max(run.row.energy_error, report.linear_energy_error);
    run.imbalance_nj.push_back(std::abs(report.energy.imbalance));
    run.handled_nj.push_back(energy_handled(report.energy));
}

// Largest imbalance of any step, relative to the energies it handled. Steps in which next to
// nothing has moved are left out, because they handle only rounding errors.
double largest_imbalance(const Run& run) {
    const double most = *std::max_element(run.handled_nj.begin(), run.handled_nj.end());
    double largest = 0.0;
    for (std::size_t k = 0; k < run.handled_nj.size(); ++k)
        if (run.handled_nj[k] > 1e-6 * most)
            largest = std::max(largest, run.imbalance_nj[k] / run.handled_nj[k]);
    return largest;
}

}  // namespace

std::vector<StepRow> study_steps(const StepStudyOptions& options, Job& job) {
    JobWithin meshing(job);
    BodyDescription body =
        body_of(options.tree.segments.empty() ? study_tree(6, 6.0) : options.tree,
                options.tetrahedra, meshing.job());
    body.material.damping_ratio = 0.3;
    body.tether_pa_per_mm2 = options.tether_pa_per_mm2;
    const int tip = furthest_vertex(body);
    std::vector<Run> runs;
    for (const int threads : options.threads) {
        Run run;
        run.row.threads = threads;
        run.row.tetrahedra = static_cast<int>(body.mesh.tetrahedra.size());
        run.stepper = make_cpu_stepper(body, {.sleeping = false});
        run.stepper->set_gravity(Vec3(0.0, 0.0, -options.gravity_mm_s2));
        runs.push_back(std::move(run));
    }
    for (int first = 0; first < options.frames; first += frames_per_batch) {
        for (Run& run : runs) {
            const ThreadLimit limit(run.row.threads);
            for (int k = first; k < std::min(options.frames, first + frames_per_batch); ++k) {
                job.advance(static_cast<double>(k) / options.frames);
                advance(run, led_around(tip, body.mesh.vertices_mm[tip], k), job);
            }
        }
    }
    std::vector<StepRow> rows;
    for (Run& run : runs) {
        run.row.ms = quantile(run.ms, 0.5);
        run.row.longest_ms = quantile(run.ms, 0.95);
        run.row.iterations /= options.frames;
        run.row.newton_iterations /= options.frames;
        run.row.ledger_imbalance = largest_imbalance(run);
        run.row.hash = hash_of(*run.stepper);
        rows.push_back(run.row);
    }
    return rows;
}

}  // namespace hepatica
