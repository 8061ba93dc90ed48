// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/region_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/deform/live_stepper.h"
#include "core/study/vessel_body.h"

namespace hepatica {

namespace {

constexpr double dt_s = 1.0 / 60.0;
constexpr double twig_radius_mm = 1.7;
constexpr int tetrahedra_per_branch = 850;

// The vertex furthest from the root.
int tip_of(const BodyDescription& body) {
    int furthest = 0;
    for (std::size_t v = 0; v < body.mesh.vertices_mm.size(); ++v) {
        if (body.mesh.vertices_mm[v].norm() > body.mesh.vertices_mm[furthest].norm()) {
            furthest = static_cast<int>(v);
        }
    }
    return furthest;
}

Grab grab_at(int vertex, const Vec3& start_mm, int frame) {
    const double angle = 0.05 * frame;
    Grab grab;
    grab.vertices[0] = vertex;
    grab.target_mm = start_mm + Vec3(0.0, 2.0 * std::sin(angle), 2.0 - 2.0 * std::cos(angle));
    grab.stiffness_un_per_mm = 2e4;
    grab.force_limit_un = 1e5;
    return grab;
}

double timed_step_ms(Stepper& stepper, const Grab& grab) {
    const auto start = std::chrono::steady_clock::now();
    stepper.set_grabs(std::span(&grab, 1));
    stepper.step(dt_s);
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
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
    const auto live = make_live_stepper(body, stepper_options);
    const auto whole = make_cpu_stepper(body, stepper_options);
    for (int k = 0; k < 60; ++k) live->step(dt_s);  // at rest, until it sleeps

    RegionRow row;
    row.tetrahedra = static_cast<int>(body.mesh.tetrahedra.size());
    const int tip = tip_of(body);
    std::vector<double> live_ms, whole_ms;
    for (int k = 0; k < options.frames; ++k) {
        job.advance(0.5 * k / options.frames);
        live_ms.push_back(timed_step_ms(*live, grab_at(tip, body.mesh.vertices_mm[tip], k)));
        row.live_tetrahedra = std::max(row.live_tetrahedra, live->extent().live_elements);
    }
    // One after the other: the whole body's step would empty the caches of the live part's.
    for (int k = 0; k < options.frames; ++k) {
        job.advance(0.5 + 0.5 * k / options.frames);
        whole_ms.push_back(timed_step_ms(*whole, grab_at(tip, body.mesh.vertices_mm[tip], k)));
    }
    row.live_ms = median(live_ms);
    row.live_longest_ms = *std::max_element(live_ms.begin(), live_ms.end());
    row.whole_ms = median(whole_ms);
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
