// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/region_study.h"

#include <algorithm>
#include <cmath>

#include "core/deform/live_stepper.h"
#include "core/study/timing.h"
#include "core/study/vessel_body.h"

namespace hepatica {

namespace {

constexpr double dt_s = 1.0 / 60.0;
constexpr double twig_radius_mm = 1.7;
constexpr int tetrahedra_per_branch = 850;

double timed_step_ms(Stepper& stepper, const Grab& grab) {
    return timed_ms([&] {
        stepper.set_grabs(std::span(&grab, 1));
        stepper.step(dt_s);
    });
}

RegionRow measure(int generations, const RegionStudyOptions& options, Job& job) {
    const double root_radius =
        twig_radius_mm * std::pow(2.0, static_cast<double>(generations - 1) / 3.0);
    Job meshing;  // its stages are none of the caller's
    const int branches = (1 << generations) - 1;
    BodyDescription body =
        body_of(study_tree(generations, root_radius), branches * tetrahedra_per_branch, meshing);
    body.tether_pa_per_mm2 = options.tether_pa_per_mm2;
    body.material.damping_ratio = 0.3;
    StepperOptions stepper_options;
    stepper_options.sleeping = false;
    const auto live = make_live_stepper(body, stepper_options, options.region);
    const auto whole = make_cpu_stepper(body, stepper_options);
    for (int k = 0; k < 60; ++k) live->step(dt_s);  // at rest, until it sleeps

    RegionRow row;
    row.tetrahedra = static_cast<int>(body.mesh.tetrahedra.size());
    const int tip = furthest_vertex(body);
    std::vector<double> live_ms, whole_ms;
    for (int k = 0; k < options.frames; ++k) {
        job.advance(0.5 * k / options.frames);
        live_ms.push_back(timed_step_ms(*live, led_around(tip, body.mesh.vertices_mm[tip], k)));
        row.live_tetrahedra = std::max(row.live_tetrahedra, live->extent().live_elements);
    }
    // One after the other: the whole body's step would empty the caches of the live part's.
    for (int k = 0; k < options.frames; ++k) {
        job.advance(0.5 + 0.5 * k / options.frames);
        whole_ms.push_back(timed_step_ms(*whole, led_around(tip, body.mesh.vertices_mm[tip], k)));
    }
    row.live_ms = quantile(live_ms, 0.5);
    row.live_longest_ms = *std::max_element(live_ms.begin(), live_ms.end());
    row.whole_ms = quantile(whole_ms, 0.5);
    for (std::size_t v = 0; v < body.mesh.vertices_mm.size(); ++v) {
        row.difference_mm = std::max(row.difference_mm,
                                     (live->positions_mm()[v] - whole->positions_mm()[v]).norm());
    }
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
