// SPDX-License-Identifier: GPL-3.0-or-later
// hepatica::DeformPart: how its body tears, and how data per vertex follow.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/deform/body/torn_body.h"
#include "core/scene/cut_line.h"
#include "core/scene/deform_part.h"
#include "core/scene/vessel_direction.h"
#include "core/tear/tearing.h"

namespace hepatica {

namespace {

constexpr double blade_radii = 1.3;  // reach of a blade to both sides of a vessel's axis

// 1 for each vertex that has come apart from another one that it was split from or with, and is no
// longer tied to it. All 0 until a joint has come apart completely, because only then the body
// counts as torn.
std::shared_ptr<const std::vector<std::uint8_t>> rims_of(const Tearing& tearing) {
    auto rims = std::make_shared<std::vector<std::uint8_t>>(tearing.topology().vertex_count(), 0);
    if (tearing.report().joints_broken == 0) return rims;
    std::vector<std::array<int, 2>> bound = tearing.bound_pairs();
    for (auto& [a, b] : bound)
        if (a > b) std::swap(a, b);
    std::ranges::sort(bound);
    for (const std::array<int, 2>& pair : tearing.parted_pairs()) {
        if (std::ranges::binary_search(bound, pair)) continue;
        for (const int v : pair) (*rims)[v] = 1;
    }
    return rims;
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
    if (!tear) mend();
    rebuild(std::move(body), setting_);
    tear_ = tear;
}

void DeformPart::show_tear(TearView& view) const {
    const TearReport& report = stepper_->tearing()->report();
    if (view.origins && (!view.rims || view.joints_broken != report.joints_broken))
        view.rims = rims_of(*stepper_->tearing());
    view.joints_broken = report.joints_broken;
    view.pieces = report.pieces;
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

int DeformPart::pieces() const {
    const Tearing* tearing = stepper_->tearing();
    return tearing != nullptr ? tearing->report().pieces : 0;
}

double DeformPart::critical_opening_mm() const {
    const Tearing* tearing = stepper_->tearing();
    return tearing != nullptr ? tearing->law().softening().opening_mm : 0.0;
}

std::vector<PressedStretch> DeformPart::pressed() const {
    const ToolLoad& load = stepper_->tool_load();
    if (!tool() || load.touched.empty()) return {};
    if (areas_mm2_.empty())
        areas_mm2_ = vertex_areas_mm2(
            torn() != nullptr ? torn()->surface() : boundary_triangles(body_.mesh), rest_mm_);
    return pressed_stretches(load, places_, areas_mm2_);
}

const TornTopology* DeformPart::torn() const {
    const Tearing* tearing = stepper_->tearing();
    return tearing != nullptr ? &tearing->topology() : nullptr;
}

void DeformPart::follow_tear() {
    const TornTopology* topology = torn();
    const std::uint64_t version = topology != nullptr ? topology->version() : 1;
    if (version == followed_) return;
    areas_mm2_.clear();
    const std::size_t whole = body_.mesh.vertices_mm.size();
    std::vector<int> parents(whole);
    std::iota(parents.begin(), parents.end(), 0);
    if (topology != nullptr) parents.assign(topology->parents().begin(), topology->parents().end());
    // Vertices of another tear have other parents.
    rest_mm_.resize(whole);
    fixed_.resize(whole);
    places_.resize(whole);
    inherit(parents, rest_mm_);
    inherit(parents, fixed_);
    inherit(parents, places_);
    const auto surface = topology != nullptr ? topology->surface() : boundary_triangles(body_.mesh);
    std::vector<std::uint8_t> on_surface(parents.size(), 0);
    for (const auto& triangle : surface)
        for (const int v : triangle) on_surface[v] = 1;
    surface_vertices_.clear();
    for (std::size_t v = 0; v < on_surface.size(); ++v)
        if (on_surface[v]) surface_vertices_.push_back(static_cast<int>(v));
    followed_ = version;  // at the end: where memory lacks, the next call tries again
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
    if (!point_mm.allFinite())
        throw InputError("the point is not finite", "cut", "Give finite numbers");
    const std::span<const Vec3> positions = positions_mm();
    int nearest = surface_vertices_.front();
    for (const int v : surface_vertices_)
        if ((positions[v] - point_mm).squaredNorm() < (positions[nearest] - point_mm).squaredNorm())
            nearest = v;
    return nearest;
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
    const TreePoint from = places_[vertex_near(from_mm)].on_tree;
    const TreePoint to = places_[vertex_near(to_mm)].on_tree;
    const std::vector<int> joints =
        joints_along(tree, torn()->joints(), places_of_tetrahedra(tree), from, to, edge_mm_);
    if (joints.empty())
        throw InputError("leads along no vessel", "the cut line",
                         "Give two places on one system, on a vessel wide enough to have joints");
    stepper_->weaken(joints, strength);
}

// The centre of the present positions of the vessel within a radius along it.
Vec3 DeformPart::axis_near(const VertexPlace& place) const {
    const std::span<const Vec3> positions = positions_mm();
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (std::size_t v = 0; v < places_.size(); ++v) {
        const TreePoint& other = places_[v].on_tree;
        if (other.segment != place.on_tree.segment ||
            std::abs(other.arclength_mm - place.on_tree.arclength_mm) > place.radius_mm)
            continue;
        sum += positions[v];
        ++count;
    }
    return sum / count;
}

void DeformPart::cut(const VesselTree& tree, const Vec3& from_mm, const Vec3& to_mm) {
    require_tear();
    const Vec3 middle = 0.5 * (from_mm + to_mm);
    const VertexPlace place = places_[vertex_near(middle)];
    BladeSweep sweep = blade_sweep(from_mm, to_mm, vessel_direction(tree, place.on_tree),
                                   blade_radii * place.radius_mm);
    // The way may be drawn on the vessel's wall, but the blade is centred on the vessel's axis, so
    // that nothing behind the vessel is cut.
    const Vec3 edge = sweep.edge_mm.normalized();
    sweep.corner_mm += (axis_near(place) - middle).dot(edge) * edge;
    stepper_->cut(sweep.corner_mm, sweep.way_mm, sweep.edge_mm);
    follow_tear();
}

void DeformPart::mend() {
    stepper_->set_tear({});
    follow_tear();
}

}  // namespace hepatica
