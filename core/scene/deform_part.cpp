// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/deform_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/base/number_text.h"
#include "core/base/patient_space.h"
#include "core/scene/measured_dial.h"
#include "core/scene/setting_json.h"
#include "core/scene/tool_at_body.h"
#include "core/tear/tearing.h"

namespace hepatica {

namespace {

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

std::vector<Grab> grabs_of(const std::optional<Hold>& hold) {
    return hold ? springs_of(*hold) : std::vector<Grab>{};
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
    vertices_.emplace(body_.mesh, patient.tree, spec.fixed);
    body_.fixed = vertices_->fixed();
    Vec3 low = body_.mesh.vertices_mm.front(), high = low;
    for (const Vec3& vertex : body_.mesh.vertices_mm) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    size_mm_ = (high - low).norm();
    edge_mm_ = mean_edge_mm(body_.mesh);
    tear_ = tear;
    body_.tear = law_of(tear);
    stepper_ = back_end_.make(body_, setting_, region_);
    stepper_->set_gravity(gravity_mm_per_s2_);
}

DeformPart::~DeformPart() = default;

void DeformPart::rebuild(BodyDescription body, const StepperOptions& setting) {
    std::unique_ptr<Stepper> stepper = back_end_.make(body, setting, region_);
    stepper->set_gravity(gravity_mm_per_s2_);
    if (stepper_->tearing() != nullptr) stepper->set_tear(stepper_->tearing()->state());
    give_state(*stepper, state());
    stepper->set_grabs(grabs_of(hold_));
    if (body.touchable) stepper->set_tool(stepper_->tool());
    // Nothing below throws, except for lack of memory.
    body_ = std::move(body);
    setting_ = setting;
    stepper_ = std::move(stepper);
    follow_tear();
}

StepReport DeformPart::step(double dt_s, const std::stop_token& stop,
                            const Stepper::PartDone& part_done) {
    const StepReport report = stepper_->step(dt_s, stop, part_done);
    follow_tear();
    return report;
}

void DeformPart::grab(const Vec3& point_mm) {
    require_reachable(point_mm, "the point to hold");
    close_hand(vertices_->nearest(point_mm, positions_mm()), point_mm);
}

void DeformPart::grab_vertex(int vertex) {
    const std::size_t count = vertices_->rest_mm().size();
    if (vertex < 0 || vertex >= static_cast<int>(count))
        throw InputError("vertex " + std::to_string(vertex) + " does not exist", "grab",
                         "The body has vertices 0 to " + std::to_string(count - 1));
    close_hand(vertex, positions_mm()[vertex]);
}

double DeformPart::hand_pressure_pa() const {
    const double pressure_pa = hand_strain * body_.material.young_modulus_pa;
    return body_.tear ? std::max(pressure_pa, 2.0 * strength_pa_ * tear_->tear_factor)
                      : pressure_pa;
}

void DeformPart::close_hand(int vertex, const Vec3& point_mm) {
    set_hold(hold_around(vertex, point_mm, *vertices_, positions_mm(),
                         body_.material.young_modulus_pa, hand_pressure_pa()));
}

void DeformPart::move_grab(const Vec3& target_mm) {
    require_reachable(target_mm, "the hand's position");
    if (!hold_) return;
    Hold hold = *hold_;
    hold.target_mm = target_mm;
    set_hold(std::move(hold));
}

void DeformPart::release() {
    if (hold_) set_hold(std::nullopt);
}

void DeformPart::set_hold(std::optional<Hold> hold) {
    stepper_->set_grabs(grabs_of(hold));
    hold_ = std::move(hold);
}

void DeformPart::add_tool(const ToolChoice& choice, const Vec3& towards_mm) {
    Tool tool = tool_of(choice, towards_mm, body_.material.young_modulus_pa, hand_pressure_pa());
    stepper_->set_tool(brought_from_outside(std::move(tool), choice.direction.normalized(),
                                            present_surface(body_.mesh, torn()), positions_mm(),
                                            body_.obstacles.get()));
    ++tools_added_;
}

void DeformPart::lead_jaws(bool open, double share) {
    if (!tool()) return;
    const double widest = widest_opening_mm(*tool()), led = tool()->opening_target_mm;
    if (widest == 0.0)
        throw InputError("has no jaws", "the tool", "Take the forceps to open and close them");
    const double goal = open ? widest : 0.0;
    stepper_->open_tool(share == 1.0 ? goal : led + share * (goal - led));
}

void DeformPart::lead_tool(const Vec3& target_mm) {
    require_reachable(target_mm, "the place of the tool");
    stepper_->lead_tool(target_mm);
}

std::optional<ToolView> DeformPart::tool_view() const {
    const std::optional<Tool>& tool = stepper_->tool();
    if (!tool) return std::nullopt;
    return view_of(*tool, stepper_->tool_load());
}

std::optional<GrabView> DeformPart::grab_view() const {
    if (!hold_) return std::nullopt;
    return view_of(*hold_, positions_mm());
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
    // The present setting may be one that does not tear.
    const bool begins_to_tear = settings.tear && !tear_;
    if (begins_to_tear && !same_setting(settings.stepper, setting_)) use(settings.stepper);
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
    if (checkpoint.hold)
        require_hold_of(checkpoint.stepper.nodes.positions_mm.size(), *checkpoint.hold);
    use(checkpoint.settings, std::move(obstacles));
    stepper_->restore(checkpoint.stepper);
    follow_tear();
    hold_ = checkpoint.hold;
    ++tools_added_;  // the tool may be another one, at another place
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
    if (hold_) add_to(hasher, *hold_);
    return hasher.value();
}

bool DeformPart::plausible() const {
    const std::span<const Vec3> positions = positions_mm();
    for (std::size_t v = 0; v < positions.size(); ++v) {
        const double moved_mm = (positions[v] - vertices_->rest_mm()[v]).norm();
        if (!(moved_mm <= 10.0 * size_mm_)) return false;
    }
    return true;
}

}  // namespace hepatica
