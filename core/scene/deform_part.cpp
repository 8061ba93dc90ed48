// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/deform_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/base/number_text.h"
#include "core/mesh/surface.h"
#include "core/scene/measured_dial.h"
#include "core/scene/setting_json.h"
#include "core/tear/tearing.h"

namespace hepatica {

namespace {

// Counts as the limit, because a tool moves in increments and stops before exceeding it.
constexpr double at_limit_share = 0.9;

const MaterialPreset& material_named(const std::string& name) {
    std::string known;
    for (const MaterialPreset& preset : material_presets()) {
        if (preset.name == name) return preset;
        known += (known.empty() ? "" : ", ") + preset.name;
    }
    throw InputError("\"" + name + "\" is not known", "material", "Choose one of: " + known);
}

double mean_edge_mm(const TetMesh& mesh) {
    double sum = 0.0;
    for (const auto& corners : mesh.tetrahedra)
        for (int a = 1; a < 4; ++a)
            sum += (mesh.vertices_mm[corners[a]] - mesh.vertices_mm[corners[0]]).norm();
    return sum / (3.0 * static_cast<double>(mesh.tetrahedra.size()));
}

std::uint64_t hash_of(const Obstacles& obstacles) {
    Hasher hasher;
    for (const Obstacle& obstacle : obstacles.all) {
        for (const Vec3& x : obstacle.surface.vertices_mm) hasher.add_bytes(x.data(), sizeof(Vec3));
        for (const auto& triangle : obstacle.surface.triangles)
            hasher.add(std::span<const int>(triangle));
    }
    return hasher.value();
}

CoarseSkeleton skeleton_of(const VesselTree& tree) {
    std::vector<SkeletonPolyline> polylines;
    for (const VesselSegment& segment : tree.segments)
        polylines.push_back({segment.points_mm, segment.radii_mm, segment.parent});
    return resample(polylines);
}

// The obstacles that a tool cannot pass: see ToolObstacle.
std::vector<const Obstacle*> solids_of(const BodyDescription& body) {
    std::vector<const Obstacle*> solids;
    if (!body.obstacles) return solids;
    for (const Obstacle& obstacle : body.obstacles->all)
        if (obstacle.kind == SurfaceKind::solid) solids.push_back(&obstacle);
    return solids;
}

}  // namespace

DeformPart::DeformPart(const PatientCase& patient, const DeformSpec& spec,
                       const LiveRegionOptions& live_region, DeformBackEnd back_end,
                       const std::optional<ContactSpec>& contact,
                       const std::optional<TearSpec>& tear,
                       std::shared_ptr<const Obstacles> obstacles)
    : region_(live_region),
      back_end_(std::move(back_end)),
      wall_mm_(spec.wall_mm),
      gravity_mm_per_s2_(spec.gravity_mm_per_s2) {
    if (patient.mesh.tetrahedra.empty())
        throw InputError("has no mesh, so its vessels cannot be moved", "the case",
                         "Reconstruct the patient again");
    const QualityDial dial =
        tear ? dial_that_tears(dial_of(patient, back_end_)) : dial_of(patient, back_end_);
    setting_ = spec.setting ? *spec.setting : dial.at(spec.quality).options;
    setting_.velocity_error = spec.velocity_error;
    body_.mesh = patient.mesh;
    body_.touchable = contact && contact->tools;
    if (contact && contact->self) body_.self = SelfPad{.friction = contact->friction};
    if (obstacles) obstacles_hash_ = hash_of(*obstacles);
    body_.obstacles = std::move(obstacles);
    const MaterialPreset& preset = material_named(spec.material);
    body_.material = preset.material;
    strength_pa_ = preset.strength_pa;
    fracture_energy_j_m2_ = preset.fracture_energy_j_m2;
    body_.tether_pa_per_mm2 = spec.tether_pa_per_mm2;
    body_.skeleton = skeleton_of(patient.tree);
    validate_wall(spec.wall_mm);
    if (spec.wall_mm > 0.0) make_hollow(body_, spec.wall_mm);
    surface_vertices_ = surface_of(body_.mesh).body_vertex;
    places_ = places_of(body_.mesh.vertices_mm, patient.tree);
    fix_ends(patient.tree, spec.fixed);
    Vec3 low = body_.mesh.vertices_mm.front(), high = low;
    for (const Vec3& vertex : body_.mesh.vertices_mm) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    size_mm_ = (high - low).norm();
    edge_mm_ = mean_edge_mm(body_.mesh);
    tear_ = tear;
    body_.tear = law_of(tear);
    rest_mm_ = body_.mesh.vertices_mm;
    fixed_ = body_.fixed;
    stepper_ = back_end_.make(body_, setting_, region_);
    stepper_->set_gravity(gravity_mm_per_s2_);
}

DeformPart::~DeformPart() = default;

void DeformPart::fix_ends(const VesselTree& tree, FixedEnds ends) {
    body_.fixed.assign(body_.mesh.vertices_mm.size(), 0);
    if (ends == FixedEnds::none) return;
    const std::vector<int> degrees = node_degrees(tree);
    std::vector<std::vector<int>> vertices_of(tree.segments.size());
    for (std::size_t v = 0; v < places_.size(); ++v)
        vertices_of[places_[v].on_tree.segment].push_back(static_cast<int>(v));
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        const VesselSegment& segment = tree.segments[s];
        const auto fix_around = [&](const Vec3& end, double radius_mm) {
            for (const int v : vertices_of[s])
                if ((body_.mesh.vertices_mm[v] - end).norm() < 1.3 * radius_mm) body_.fixed[v] = 1;
        };
        if (segment.parent < 0 && degrees[segment.proximal_node] == 1)
            fix_around(segment.points_mm.front(), segment.radii_mm.front());
        if (ends == FixedEnds::all && degrees[segment.distal_node] == 1)
            fix_around(segment.points_mm.back(), segment.radii_mm.back());
    }
}

void DeformPart::rebuild(BodyDescription body, const StepperOptions& setting) {
    std::unique_ptr<Stepper> stepper = back_end_.make(body, setting, region_);
    stepper->set_gravity(gravity_mm_per_s2_);
    if (stepper_->tearing() != nullptr) stepper->set_tear(stepper_->tearing()->state());
    give_state(*stepper, state());
    stepper->set_grabs(springs_of(hold_));
    if (body.touchable) stepper->set_tool(stepper_->tool());
    // Nothing below throws, except for lack of memory.
    body_ = std::move(body);
    setting_ = setting;
    stepper_ = std::move(stepper);
    follow_tear();
}

StepReport DeformPart::step(double dt_s, const std::stop_token& stop) {
    const StepReport report = stepper_->step(dt_s, stop);
    follow_tear();
    return report;
}

void DeformPart::grab(const Vec3& point_mm) {
    if (!point_mm.allFinite())
        throw InputError("the point to hold is not finite", "grab", "Give finite numbers");
    const std::span<const Vec3> positions = positions_mm();
    int nearest = surface_vertices_.front();
    for (const int v : surface_vertices_)
        if ((positions[v] - point_mm).squaredNorm() < (positions[nearest] - point_mm).squaredNorm())
            nearest = v;
    close_hand(nearest, point_mm);
}

void DeformPart::grab_vertex(int vertex) {
    if (vertex < 0 || vertex >= static_cast<int>(rest_mm_.size()))
        throw InputError("vertex " + std::to_string(vertex) + " does not exist", "grab",
                         "The body has vertices 0 to " + std::to_string(rest_mm_.size() - 1));
    close_hand(vertex, positions_mm()[vertex]);
}

double DeformPart::hand_pressure_pa() const {
    const double pressure_pa = hand_strain * body_.material.young_modulus_pa;
    return body_.tear ? std::max(pressure_pa, 2.0 * strength_pa_ * tear_->tear_factor)
                      : pressure_pa;
}

void DeformPart::close_hand(int vertex, const Vec3& point_mm) {
    const std::span<const Vec3> positions = positions_mm();
    const double radius_mm = places_[vertex].radius_mm;
    const Vec3 centre_now = positions[vertex];
    const Vec3 centre_at_rest = rest_mm_[vertex];
    Hold hold;
    for (std::size_t v = 0; v < positions.size(); ++v) {
        // The vertices must be near at rest, too, so that another vessel that lies beside this one
        // is not held.
        const bool near = (positions[v] - centre_now).norm() <= radius_mm &&
                          (rest_mm_[v] - centre_at_rest).norm() <= 2.0 * radius_mm;
        if (near && fixed_[v] == 0) hold.vertices.push_back(static_cast<int>(v));
    }
    if (hold.vertices.empty()) hold.vertices.push_back(vertex);
    for (const int v : hold.vertices) hold.offsets_mm.push_back(positions[v] - point_mm);
    // All springs together are as stiff as a piece of the vessel one radius long. Their force limit
    // is high, because a weaker hand could not move a vessel that its tissue holds.
    const double modulus_pa = body_.material.young_modulus_pa;
    const auto springs = static_cast<double>(hold.vertices.size());
    hold.target_mm = point_mm;
    hold.stiffness_un_per_mm = modulus_pa * M_PI * radius_mm / springs;
    hold.force_limit_un = hand_pressure_pa() * M_PI * radius_mm * radius_mm / springs;
    set_hold(std::move(hold));
}

void DeformPart::move_grab(const Vec3& target_mm) {
    if (!target_mm.allFinite())
        throw InputError("the hand's position is not finite", "move_grab", "Give finite numbers");
    if (!hold_) return;
    Hold hold = *hold_;
    hold.target_mm = target_mm;
    set_hold(std::move(hold));
}

void DeformPart::release() {
    if (hold_) set_hold(std::nullopt);
}

std::vector<Grab> DeformPart::springs_of(const std::optional<Hold>& hold) {
    std::vector<Grab> grabs;
    for (std::size_t i = 0; hold && i < hold->vertices.size(); ++i) {
        Grab spring;
        spring.vertices[0] = hold->vertices[i];
        spring.target_mm = hold->target_mm + hold->offsets_mm[i];
        spring.stiffness_un_per_mm = hold->stiffness_un_per_mm;
        spring.force_limit_un = hold->force_limit_un;
        grabs.push_back(spring);
    }
    return grabs;
}

void DeformPart::set_hold(std::optional<Hold> hold) {
    stepper_->set_grabs(springs_of(hold));
    hold_ = std::move(hold);
}

void DeformPart::add_tool(const ToolChoice& choice, const Vec3& towards_mm) {
    Tool tool = tool_of(choice, towards_mm, body_.material.young_modulus_pa, hand_pressure_pa());
    const Vec3 direction = choice.direction.normalized();
    // Starts outside: farther away than anything of a plausible body.
    Box box;
    for (const Vec3& x : positions_mm()) box.add(x);
    for (const Obstacle* solid : solids_of(body_))
        for (const Vec3& x : solid->surface.vertices_mm) box.add(x);
    Vec3 length = Vec3::Zero();
    for (const ToolPart& part : tool.parts) {
        box.add(part.shape.centre_mm);
        const Vec3 half = part.shape.half_axis_mm + part.shape.radius_mm * direction;
        if (half.norm() > length.norm()) length = half;
    }
    const Vec3 way = (box.high - box.low).norm() * direction;
    const Vec3 there = tool.parts.front().shape.centre_mm;
    for (ToolPart& part : tool.parts) part.shape.centre_mm -= way;
    for (ToolPart& part : tool.parts) part.shape.centre_mm -= 2.0 * length;
    const SurfacePatches surface(torn() != nullptr ? torn()->surface()
                                                   : boundary_triangles(body_.mesh));
    Vec3 gone = approach(tool.shapes(), {{surface, positions_mm()}},
                         there - tool.parts.front().shape.centre_mm, tool.pad_mm);
    for (const Obstacle* solid : solids_of(body_))
        gone = approach(tool.shapes(),
                        {{SurfacePatches(solid->surface.triangles), solid->surface.vertices_mm}},
                        gone, tool.pad_mm);
    for (ToolPart& part : tool.parts) part.shape.centre_mm += gone;
    tool.target_mm = tool.centre_mm();
    stepper_->set_tool(tool);
}

void DeformPart::lead_jaws(bool open, double share) {
    if (!tool()) return;
    const double widest = widest_opening_mm(*tool()), led = tool()->opening_target_mm;
    if (widest == 0.0)
        throw InputError("has no jaws", "the tool", "Take the forceps to open and close them");
    const double goal = open ? widest : 0.0;
    stepper_->open_tool(share == 1.0 ? goal : led + share * (goal - led));
}

std::optional<ToolView> DeformPart::tool_view() const {
    const std::optional<Tool>& tool = stepper_->tool();
    if (!tool) return std::nullopt;
    ToolView view;
    const auto share = 1.0 / static_cast<double>(tool->parts.size());
    for (const ToolPart& part : tool->parts) {
        const Segment axis = part.shape.axis();
        view.parts.push_back({axis[0], axis[1], part.shape.radius_mm});
        view.tip_mm += share * axis[1];
    }
    view.centre_mm = tool->centre_mm();
    view.opening_mm = tool->opening_mm;
    const ToolLoad& load = stepper_->tool_load();
    view.force_un = load.force_un;
    view.at_mm = load.at_mm;
    view.grip_un = load.grip_un;
    view.at_limit =
        std::max(load.force_un.norm(), load.grip_un) >= at_limit_share * tool->force_limit_un;
    view.touched = load.touched;
    return view;
}

std::optional<GrabView> DeformPart::grab_view() const {
    if (!hold_) return std::nullopt;
    const std::span<const Vec3> positions = positions_mm();
    GrabView view;
    view.target_mm = hold_->target_mm;
    Vec3 force_un = Vec3::Zero();
    std::size_t limited = 0;
    for (std::size_t i = 0; i < hold_->vertices.size(); ++i) {
        const Vec3 held = positions[hold_->vertices[i]] - hold_->offsets_mm[i];
        view.point_mm += held / static_cast<double>(hold_->vertices.size());
        const Vec3 pull = hold_->stiffness_un_per_mm * (hold_->target_mm - held);
        limited += pull.norm() >= hold_->force_limit_un ? 1 : 0;
        force_un += pull * std::min(1.0, hold_->force_limit_un / std::max(pull.norm(), 1e-300));
    }
    view.force_un = force_un.norm();
    view.at_limit = 2 * limited >= hold_->vertices.size();
    return view;
}

void DeformPart::set_gravity(const Vec3& gravity_mm_per_s2) {
    stepper_->set_gravity(gravity_mm_per_s2);
    gravity_mm_per_s2_ = gravity_mm_per_s2;
}

void DeformPart::set_tether(double pa_per_mm2) {
    if (!(pa_per_mm2 >= 0.0) || !std::isfinite(pa_per_mm2))
        throw InputError("is " + number_text(pa_per_mm2), "tether", "Give 0 or more");
    BodyDescription body = body_;
    body.tether_pa_per_mm2 = pa_per_mm2;
    rebuild(std::move(body), setting_);
}

void DeformPart::set_wall(double wall_mm) {
    validate_wall(wall_mm);
    BodyDescription body = body_;
    body.stiffness_factor.clear();
    if (wall_mm > 0.0) make_hollow(body, wall_mm);
    rebuild(std::move(body), setting_);
    wall_mm_ = wall_mm;
}

void DeformPart::set_touchable(bool touchable) {
    if (touchable == body_.touchable) return;
    BodyDescription body = body_;
    body.touchable = touchable;
    rebuild(std::move(body), setting_);
}

void DeformPart::set_contact(const std::optional<double>& self_friction,
                             std::shared_ptr<const Obstacles> obstacles) {
    if (self_friction) validate_friction(*self_friction);
    const bool same_self = body_.self ? self_friction == body_.self->friction : !self_friction;
    if (same_self && obstacles == body_.obstacles) return;
    BodyDescription body = body_;
    body.self.reset();
    if (self_friction) body.self = SelfPad{.friction = *self_friction};
    body.obstacles = std::move(obstacles);
    std::unique_ptr<Stepper> stepper = back_end_.make(body, setting_, region_);
    stepper->set_gravity(gravity_mm_per_s2_);
    // Nothing below throws, except for lack of memory.
    hold_.reset();
    obstacles_hash_ = body.obstacles ? hash_of(*body.obstacles) : 0;
    body_ = std::move(body);
    stepper_ = std::move(stepper);
    follow_tear();
}

void DeformPart::use(const StepperOptions& setting) {
    StepperOptions now = setting;
    now.velocity_error = setting_.velocity_error;
    if (now.on_processor == setting_.on_processor && stepper_->set_options(now))
        setting_ = now;
    else
        rebuild(body_, now);
}

void DeformPart::give_state(Stepper& stepper, const BodyState& state) const {
    std::span<const Vec3> positions = state.positions_mm, velocities = state.velocities_mm_per_s;
    const std::size_t vertices = stepper.positions_mm().size();
    if (positions.size() != stepper.state().positions_mm.size() && positions.size() > vertices) {
        positions = positions.first(vertices);
        velocities = velocities.first(vertices);
    }
    stepper.set_state(positions, velocities);
}

DeformSettings DeformPart::settings() const {
    DeformSettings now{gravity_mm_per_s2_, body_.tether_pa_per_mm2, wall_mm_,
                       setting_,           body_.touchable,         tear_};
    if (body_.self) now.self_friction = body_.self->friction;
    now.obstacles = body_.obstacles != nullptr;
    return now;
}

void DeformPart::use(const DeformSettings& settings, std::shared_ptr<const Obstacles> obstacles) {
    if (!obstacles) obstacles = body_.obstacles;
    if (settings.obstacles && !obstacles)
        throw InputError("needs obstacles that this scene does not have", "checkpoint",
                         "Give a checkpoint of the same patient");
    set_contact(settings.self_friction, settings.obstacles ? std::move(obstacles) : nullptr);
    set_touchable(settings.touchable);
    set_tear(settings.tear);
    if (settings.gravity_mm_per_s2 != gravity_mm_per_s2_) set_gravity(settings.gravity_mm_per_s2);
    if (settings.tether_pa_per_mm2 != body_.tether_pa_per_mm2)
        set_tether(settings.tether_pa_per_mm2);
    if (settings.wall_mm != wall_mm_) set_wall(settings.wall_mm);
    if (!same_setting(settings.stepper, setting_)) use(settings.stepper);
}

DeformCheckpoint DeformPart::checkpoint() const {
    return {settings(), hold_, stepper_->checkpoint()};
}

void DeformPart::restore(const DeformCheckpoint& checkpoint,
                         std::shared_ptr<const Obstacles> obstacles) {
    if (checkpoint.hold) {
        const Hold& hold = *checkpoint.hold;
        const auto exists = [&](int v) {
            return v >= 0 &&
                   static_cast<std::size_t>(v) < checkpoint.stepper.nodes.positions_mm.size();
        };
        if (hold.offsets_mm.size() != hold.vertices.size() ||
            !std::ranges::all_of(hold.vertices, exists))
            throw InputError("holds vertices that the body does not have", "checkpoint",
                             "Give a checkpoint of the same patient");
    }
    use(checkpoint.settings, std::move(obstacles));
    stepper_->restore(checkpoint.stepper);
    follow_tear();
    hold_ = checkpoint.hold;
}

std::uint64_t DeformPart::state_hash() const {
    Hasher hasher;
    const std::uint64_t stepper = stepper_->state_hash();
    const std::string setting = to_json(setting_).dump();
    const std::array<double, 2> body{body_.tether_pa_per_mm2, wall_mm_};
    hasher.add_bytes(&stepper, sizeof stepper);
    hasher.add_bytes(setting.data(), setting.size());
    hasher.add(std::span<const double>(body));
    if (body_.obstacles) hasher.add_bytes(&obstacles_hash_, sizeof obstacles_hash_);
    if (body_.self && body_.self->friction > 0.0)
        hasher.add_bytes(&body_.self->friction, sizeof body_.self->friction);
    if (hold_) {
        const std::array<double, 2> spring{hold_->stiffness_un_per_mm, hold_->force_limit_un};
        hasher.add(std::span<const int>(hold_->vertices));
        for (const Vec3& offset : hold_->offsets_mm) hasher.add_bytes(offset.data(), sizeof(Vec3));
        hasher.add_bytes(hold_->target_mm.data(), sizeof(Vec3));
        hasher.add(std::span<const double>(spring));
    }
    return hasher.value();
}

bool DeformPart::plausible() const {
    const std::span<const Vec3> positions = positions_mm();
    for (std::size_t v = 0; v < positions.size(); ++v) {
        const double moved_mm = (positions[v] - rest_mm_[v]).norm();
        if (!(moved_mm <= 10.0 * size_mm_)) return false;
    }
    return true;
}

}  // namespace hepatica
