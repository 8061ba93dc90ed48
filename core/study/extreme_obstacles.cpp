// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of the stability suite with obstacles: a hand that jumps pulls the tip of a clamped beam
// against a block, or out of a box that contains it, at any time step. Block and box are
// axis-aligned, so that coordinates alone tell on which side a vertex is.
#include <memory>
#include <sstream>

#include "core/deform/stepper/cpu_stepper.h"
#include "core/mesh/brick_mesh.h"
#include "core/study/extreme_cases.h"
#include "core/study/reference_beam.h"
#include "core/study/trial.h"

namespace hepatica {
namespace {

struct Block {
    Vec3 low_mm, high_mm;

    bool holds(const Vec3& x) const {
        return (x.array() > low_mm.array()).all() && (x.array() < high_mm.array()).all();
    }
    TriangleMesh surface() const {
        TetMesh cut = kuhn_brick(high_mm - low_mm, {4, 4, 4});
        TriangleMesh mesh{std::move(cut.vertices_mm), boundary_triangles(cut)};
        for (Vec3& x : mesh.vertices_mm) x += low_mm;
        return mesh;
    }
};

constexpr double back_mm = 80.0;         // movement of the hand from the tip towards the clamp
constexpr double allowed_back_mm = 0.2;  // tolerance after release, for a beam of 100 mm
// The block is a little above the short beam's outer half; the box contains all of it.
const Block block{{50, -20, 21}, {110, 40, 61}};
const Block box{{-10, -1, -1}, {101, 21, 21}};

BodyDescription beam_beside(const Discretisation& how, SurfaceKind kind) {
    BodyDescription body = clamped_beam(short_beam(how), how);
    const Block& stands = kind == SurfaceKind::shell ? box : block;
    body.obstacles =
        std::make_shared<const Obstacles>(Obstacles{{Obstacle{stands.surface(), kind}}, 0.2});
    return body;
}

bool stays_out(const Stepper& stepper, const BodyDescription& body, SurfaceKind kind) {
    const std::span<const Vec3> x = stepper.positions_mm();
    // Only vertices of the mesh: mid-edge nodes of quadratic elements are no corners of the
    // surface.
    return std::ranges::all_of(x.first(body.mesh.vertices_mm.size()), [&](const Vec3& at) {
        return kind == SurfaceKind::shell ? box.holds(at) : !block.holds(at);
    });
}

// The hand jumps beyond the wall, along it and back, and lets go.
ExtremeRow run_against_wall(const std::string& element, SurfaceKind kind, double dt_s,
                            double strength_un, const ExtremeRun& how) {
    ExtremeRow row;
    const Discretisation d = discretisation_of(element);
    const BodyDescription body = beam_beside(d, kind);
    const auto stepper = make_cpu_stepper(body, {.model = d.model, .order = d.order});
    Trial trial(*stepper, row, how);
    Grab grab;
    grab.vertices[0] = static_cast<int>(body.mesh.vertices_mm.size()) - 1;
    grab.stiffness_un_per_mm = 1e5;
    grab.force_limit_un = strength_un;
    const Vec3 place = body.mesh.vertices_mm.back();
    for (const Vec3& by : {Vec3(0, 0, 1000), Vec3(-back_mm, 500, 1000), Vec3(0, 0, -1000)}) {
        grab.target_mm = place + by;
        stepper->set_grabs(std::span(&grab, 1));
        for (int k = 0; k < 20; ++k) {
            if (!trial.run(1, dt_s)) return row;
            if (!trial.require(stays_out(*stepper, body, kind), "it went through the wall"))
                return row;
        }
    }
    if (!trial.require(row.touched_steps > 0, "it never touched the wall")) return row;
    stepper->set_grabs({});
    if (trial.run(200, std::max(dt_s, 0.02)))
        trial.require_back_at(body.mesh.vertices_mm, allowed_back_mm);
    return row;
}

}  // namespace

void add_obstacle_cases(std::vector<ExtremeCase>& cases) {
    for (const char* element : {"corotated", "neohookean"})
        for (const SurfaceKind kind : {SurfaceKind::solid, SurfaceKind::shell})
            for (const double dt_s : {1e-3, 1.0 / 60.0, 0.1})
                for (const double strength_un : {1e5, 1e9}) {
                    std::ostringstream name;
                    name << (kind == SurfaceKind::shell ? "out of a box " : "into a block ")
                         << element << " dt=" << dt_s << " limit=" << strength_un;
                    cases.push_back({name.str(), [=](const ExtremeRun& how) {
                                         return run_against_wall(element, kind, dt_s, strength_un,
                                                                 how);
                                     }});
                }
}

}  // namespace hepatica
