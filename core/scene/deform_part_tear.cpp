// SPDX-License-Identifier: GPL-3.0-or-later
// hepatica::DeformPart: how its body tears, and how data per vertex follow.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/base/patient_space.h"
#include "core/deform/body/torn_body.h"
#include "core/scene/cut_line.h"
#include "core/scene/deform_part.h"
#include "core/scene/torn_rims.h"
#include "core/scene/vessel_direction.h"
#include "core/tear/tearing.h"

namespace hepatica {

namespace {

constexpr double blade_radii = 1.3;  // reach of a blade to both sides of a vessel's axis
// Within this of a fork, in radii, a section has the widths of two branches.
constexpr double of_fork_radii = 1.5;

double blade_reach_mm(const VesselTree& tree, const VertexPlace& place) {
    const VesselSegment& vessel = tree.segments[static_cast<std::size_t>(place.on_tree.segment)];
    const double from_ends =
        std::min(place.on_tree.arclength_mm, length_mm(vessel) - place.on_tree.arclength_mm);
    const double widths = from_ends < of_fork_radii * place.radius_mm ? 2.0 : 1.0;
    return widths * blade_radii * place.radius_mm;
}

}  // namespace

std::optional<TearLaw> DeformPart::law_of(const std::optional<TearSpec>& tear) const {
    if (!tear) return std::nullopt;
    return TearLaw{.strength_pa = strength_pa_,
                   .fracture_energy_j_m2 = fracture_energy_j_m2_,
                   .tear_factor = tear->tear_factor,
                   .bare_limit = tear->bare_limit,
                   .stop = tear->stop,
                   .entropy_budget_nats = tear->entropy_budget,
                   .vertex_budget = tear->vertex_budget};
}

void DeformPart::set_tear(const std::optional<TearSpec>& tear) {
    if (tear == tear_) return;
    BodyDescription body = body_;
    body.tear = law_of(tear);
    validate(body, setting_.model, setting_.order);
    if (!tear) {
        const auto whole = static_cast<int>(body_.mesh.vertices_mm.size());
        const auto vanishes = [whole](int vertex) { return vertex >= whole; };
        if (hold_ && std::ranges::any_of(hold_->vertices, vanishes)) release();
        mend();
    }
    rebuild(std::move(body), setting_);
    tear_ = tear;
}

void DeformPart::show_tear(TearView& view) const {
    const TearReport& report = stepper_->tearing()->report();
    // Before the first joint breaks, corners come apart without any other sign.
    const bool begins = report.joints_broken == 0 && report.joints_parted > 0;
    if (view.origins && (!view.rims || begins || view.joints_broken != report.joints_broken)) {
        std::vector<std::uint8_t> rims = torn_rims(*stepper_->tearing());
        if (!view.rims || *view.rims != rims)
            view.rims = std::make_shared<const std::vector<std::uint8_t>>(std::move(rims));
    }
    view.joints_broken = report.joints_broken;
    view.torn_area_mm2 = report.torn_area_mm2;
    view.pieces = report.pieces;
    view.pieces_off = report.pieces_off;
    view.entropy_nats = report.entropy_nats;
    view.entropy_produced_nats = report.entropy_produced_nats;
    view.stopped_by = !report.stopped                    ? ""
                      : tear_->stop == TearStop::entropy ? "entropy"
                                                         : "vertices";
    view.loads = vertex_loads();
    view.weak_edges = weak_edges_.of(*stepper_->tearing());
}

std::shared_ptr<const std::vector<float>> DeformPart::vertex_loads() const {
    const Tearing& tearing = *stepper_->tearing();
    const std::span<const double> of_joint = tearing.loads();
    const TornTopology& topology = tearing.topology();
    std::shared_ptr<std::vector<float>> loads;
    for (std::size_t j = 0; j < of_joint.size(); ++j) {
        if (of_joint[j] < Tearing::warning_load) continue;
        if (!loads) loads = std::make_shared<std::vector<float>>(topology.vertex_count(), 0.0f);
        for (int k = 0; k < 3; ++k)
            for (const int v : topology.sides(topology.joints()[j], k))
                (*loads)[v] = std::max((*loads)[v], static_cast<float>(of_joint[j]));
    }
    return loads;
}

TornSoFar DeformPart::torn_so_far() const {
    const Tearing* tearing = stepper_->tearing();
    if (tearing == nullptr) return {};
    int open_corners = 0;
    if (tearing->report().joints_broken > 0)  // nothing is open before
        for (const OpenJoint& open : tearing->open_joints())
            open_corners += static_cast<int>(std::ranges::count(open.corners, true));
    return {tearing->topology().version(), tearing->report().joints_broken,
            tearing->report().pieces, open_corners};
}

double DeformPart::critical_opening_mm() const {
    const Tearing* tearing = stepper_->tearing();
    return tearing != nullptr ? tearing->law().softening().opening_mm : 0.0;
}

std::vector<PressedStretch> DeformPart::pressed() const {
    const ToolLoad& load = stepper_->tool_load();
    if (!tool() || load.touched.empty()) return {};
    return pressed_stretches(load, places(), vertices_->areas_mm2(body_.mesh, torn()));
}

const TornTopology* DeformPart::torn() const {
    const Tearing* tearing = stepper_->tearing();
    return tearing != nullptr ? &tearing->topology() : nullptr;
}

TetMesh DeformPart::shape() const {
    TetMesh mesh = body_.mesh;
    if (const TornTopology* topology = torn())
        mesh.tetrahedra.assign(topology->tetrahedra().begin(), topology->tetrahedra().end());
    mesh.vertices_mm.assign(positions_mm().begin(), positions_mm().end());
    return mesh;
}

void DeformPart::require_tear() const {
    if (!tear_)
        throw InputError("nothing tears in this scene", "cut", "Add \"tear\": {} to the scene");
}

int DeformPart::vertex_near(const Vec3& point_mm) const {
    require_reachable(point_mm, "the point");
    return vertices_->nearest(point_mm, positions_mm());
}

const std::vector<VertexPlace>& DeformPart::places_of_tetrahedra(const VesselTree& tree) {
    if (!tetrahedra_.empty()) return tetrahedra_;
    std::vector<Vec3> centres;
    for (const auto& [a, b, c, d] : body_.mesh.tetrahedra)
        centres.push_back(0.25 * (body_.mesh.vertices_mm[a] + body_.mesh.vertices_mm[b] +
                                  body_.mesh.vertices_mm[c] + body_.mesh.vertices_mm[d]));
    tetrahedra_ = places_of(centres, tree);
    return tetrahedra_;
}

std::vector<ThroughTear> DeformPart::torn_through(const VesselTree& tree) {
    if (torn() == nullptr) return {};
    return through_tears(tree, *stepper_->tearing(), places_of_tetrahedra(tree), 2.0 * edge_mm_);
}

TornPlaces DeformPart::torn_places(const VesselTree& tree) {
    TornPlaces places{torn_through(tree), {}};
    if (torn() != nullptr)
        places.sides = side_tears(tree, *stepper_->tearing(), places_of_tetrahedra(tree),
                                  2.0 * edge_mm_, places.through);
    return places;
}

double DeformPart::mass_error_relative() const {
    if (torn() == nullptr) return 0.0;
    const auto mass_of = [&](const BodyDescription& body) {
        double sum = 0.0;
        for (const double mass : build_body(body, setting_.model, setting_.order).mass_g)
            sum += mass;
        return sum;
    };
    const double whole = mass_of(body_);
    return std::abs(mass_of(hepatica::torn(body_, torn_body_of(*stepper_->tearing()))) - whole) /
           whole;
}

void DeformPart::cut_line(const VesselTree& tree, const Vec3& from_mm, const Vec3& to_mm,
                          double strength) {
    require_tear();
    if (!(strength >= 0.0 && strength <= 1.0))
        throw InputError("is " + number_text(strength), "strength along a cut line",
                         "Choose a value from 0 (nothing holds) to 1 (as before)");
    const TreePoint from = places()[vertex_near(from_mm)].on_tree;
    const TreePoint to = places()[vertex_near(to_mm)].on_tree;
    const std::vector<int> joints =
        joints_along(tree, torn()->joints(), places_of_tetrahedra(tree), from, to, edge_mm_);
    if (joints.empty())
        throw InputError("leads along no vessel", "the cut line",
                         "Give two places on one system, on a vessel wide enough to have joints");
    stepper_->weaken(joints, strength);
}

void DeformPart::cut(const VesselTree& tree, const Vec3& from_mm, const Vec3& to_mm) {
    require_tear();
    const Vec3 middle = 0.5 * (from_mm + to_mm);
    const VertexPlace place = places()[vertex_near(middle)];
    BladeSweep sweep = blade_sweep(from_mm, to_mm, vessel_direction(tree, place.on_tree),
                                   blade_reach_mm(tree, place));
    // The way may be drawn on the vessel's wall, but the blade is centred on the vessel's axis, so
    // that nothing behind the vessel is cut.
    const Vec3 edge = sweep.edge_mm.normalized();
    sweep.corner_mm += (vertices_->axis_near(place, positions_mm()) - middle).dot(edge) * edge;
    stepper_->cut(sweep.corner_mm, sweep.way_mm, sweep.edge_mm);
    follow_tear();
}

void DeformPart::mend() {
    stepper_->set_tear({});
    follow_tear();
}

}  // namespace hepatica
