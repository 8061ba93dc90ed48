// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/region_study.h"

#include <algorithm>
#include <cmath>

#include "core/base/frame_time.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/live_stepper.h"
#include "core/study/job_within.h"
#include "core/study/pull_trial.h"
#include "core/study/timing.h"
#include "core/study/vessel_body.h"

namespace hepatica {

namespace {

constexpr double twig_radius_mm = 1.7;
constexpr int tetrahedra_per_branch = 850;

struct Played {
    std::vector<double> held_ms;
    std::vector<Vec3> motion;  // displacement of every vertex, frame by frame
};

// Leads the twig's tip around, then lets it go.
template <class AfterFrame>
Played play(Stepper& stepper, const BodyDescription& body, const RegionStudyOptions& options,
            const Job& job, const AfterFrame& after_frame) {
    const int tip = furthest_vertex(body);
    const std::vector<Vec3>& rest = body.mesh.vertices_mm;
    const int frames = options.frames + options.frames_after;
    Played played;
    for (int k = 0; k < frames; ++k) {
        const bool held = k < options.frames;
        const Grab grab = led_around(tip, rest[tip], k);
        const double ms = timed_ms([&] {
            stepper.set_grabs(std::span(&grab, held ? 1 : 0));
            stepper.step(frame_s, job.stop_token());
        });
        if (held) played.held_ms.push_back(ms);
        for (std::size_t v = 0; v < rest.size(); ++v)
            played.motion.push_back(stepper.positions_mm()[v] - rest[v]);
        after_frame(static_cast<double>(k + 1) / frames);
    }
    return played;
}

RegionRow measure(int generations, const RegionStudyOptions& options, Job& job) {
    const double root_radius =
        twig_radius_mm * std::pow(2.0, static_cast<double>(generations - 1) / 3.0);
    JobWithin meshing(job);
    const int branches = (1 << generations) - 1;
    BodyDescription body = body_of(study_tree(generations, root_radius),
                                   branches * tetrahedra_per_branch, meshing.job());
    body.tether_pa_per_mm2 = options.tether_pa_per_mm2;
    body.material.damping_ratio = 0.3;
    StepperOptions stepper_options;
    stepper_options.sleeping = false;
    const auto live = make_live_stepper(body, stepper_options, options.region);
    const auto whole = make_cpu_stepper(body, stepper_options);
    for (int k = 0; k < 60; ++k) live->step(frame_s, job.stop_token());  // at rest, until it sleeps

    RegionRow row;
    row.tetrahedra = static_cast<int>(body.mesh.tetrahedra.size());
    // Played one after the other, because a step of the whole body would empty the caches of the
    // live part.
    const Played part = play(*live, body, options, job, [&](double share) {
        row.live_tetrahedra = std::max(row.live_tetrahedra, live->extent().live_elements);
        job.advance(0.5 * share);
    });
    const Played all =
        play(*whole, body, options, job, [&](double share) { job.advance(0.5 + 0.5 * share); });
    row.live_ms = quantile(part.held_ms, 0.5);
    row.live_longest_ms = *std::ranges::max_element(part.held_ms);
    row.whole_ms = quantile(all.held_ms, 0.5);
    const MotionDifference difference = motion_difference(part.motion, all.motion);
    row.difference_mm = difference.largest_mm;
    // Not finite where nothing moved.
    row.rms_difference = std::isfinite(difference.relative) ? difference.relative : 0.0;
    return row;
}

}  // namespace

std::vector<RegionRow> study_region(const RegionStudyOptions& options, Job& job) {
    std::vector<RegionRow> rows;
    job.expect_stages(static_cast<int>(options.generations.size()));
    for (const int generations : options.generations) {
        job.begin_stage("a tree of " + std::to_string(generations) + " generations");
        rows.push_back(measure(generations, options, job));
    }
    return rows;
}

}  // namespace hepatica
