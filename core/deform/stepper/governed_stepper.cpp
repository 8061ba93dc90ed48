// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/stepper/governed_stepper.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/deform/potentials/load_input.h"
#include "core/deform/potentials/tool_path.h"
#include "core/deform/step/step_input.h"
#include "core/deform/stepper/cpu_back_end.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/stepper_input.h"
#include "core/mesh/hex_mesh.h"

namespace hepatica {
namespace {

constexpr double sleep_speed_edges_per_s = 1e-5;
constexpr double sleep_after_s = 0.5;
// A body that stays below this speed for this long has settled; inverted elements are then searched
// for.
constexpr double settled_speed_edges_per_s = 2e-2;
constexpr double settled_after_s = 0.25;
// Of a mean edge: what is frozen that far from its place at rest takes part in a swing.
constexpr double displaced_edges = 0.05;

// Makes the skeleton that LiveRegion needs, where the description has none.
BodyDescription with_skeleton(BodyDescription body) {
    if (body.skeleton.size() > 0) return body;
    TetMesh mesh = body.mesh;
    for (const auto& tetrahedron : cut_into_tetrahedra(body.hexahedra))
        mesh.tetrahedra.push_back(tetrahedron);
    body.skeleton = skeleton_of_mesh(mesh);
    return body;
}

const BodyDescription& validated(const BodyDescription& body, const StepperOptions& options) {
    validate(options);
    validate(body, options.model, options.order);
    return body;
}

// Speed of the fastest node, mm/s.
double fastest(const BodyState& state) {
    double squared = 0.0;
    for (const Vec3& v : state.velocities_mm_per_s) squared = std::max(squared, v.squaredNorm());
    return std::sqrt(squared);
}

}  // namespace

GovernedStepper::GovernedStepper(const BodyDescription& body, const StepperOptions& options,
                                 const std::optional<LiveRegionOptions>& region, MakeBackEnd make)
    : description_(region ? with_skeleton(validated(body, options)) : validated(body, options)),
      options_(options),
      make_(std::move(make)),
      back_end_(make_(description_, options)) {
    if (region) region_ = new_region(*region);
    if (body.tear) tearing_.emplace(body.mesh, *body.tear, body.stiffness_factor);
}

void GovernedStepper::wake() {
    still_s_ = 0.0;
    settled_s_ = 0.0;
}

bool GovernedStepper::asleep() const {
    if (region_) return region_->live_count() == 0;
    return options_.sleeping && still_s_ >= sleep_after_s;
}

// A vertex is frozen where its skeleton node is; a mid-edge node only where both ends are.
std::vector<std::uint8_t> GovernedStepper::frozen_nodes() const {
    const Body& body = back_end_->body();
    std::vector<std::uint8_t> frozen(nodes(), 0);
    for (int v = 0; v < body.vertex_count; ++v) frozen[v] = region_->live(v) ? 0 : 1;
    for (std::size_t m = 0; m < body.edge_of_middle_node.size(); ++m) {
        const auto& [a, b] = body.edge_of_middle_node[m];
        frozen[body.vertex_count + m] = frozen[a] & frozen[b];
    }
    return frozen;
}

// A frozen node has velocity zero.
void GovernedStepper::change_region() {
    const std::vector<std::uint8_t> frozen = frozen_nodes();
    const BodyState& now = back_end_->state();
    const auto moves = [&](std::size_t i) {
        return frozen[i] != 0 && !now.velocities_mm_per_s[i].isZero(0.0);
    };
    bool stops = false;
    for (std::size_t i = 0; i < frozen.size() && !stops; ++i) stops = moves(i);
    if (stops) {
        BodyState stopped = now;
        for (std::size_t i = 0; i < frozen.size(); ++i)
            if (frozen[i] != 0) stopped.velocities_mm_per_s[i].setZero();
        const double before = back_end_->kinetic_energy();
        back_end_->set_velocities(stopped.velocities_mm_per_s);
        const double loss = before - back_end_->kinetic_energy();
        lost_ += loss;
        resting_.kinetic -= loss;
    }
    back_end_->freeze(frozen);
}

void GovernedStepper::set_grabs(std::span<const Grab> grabs) {
    validate_grabs(grabs, nodes());
    const double before = back_end_->grab_energy();
    back_end_->set_grabs(grabs);
    const double after = back_end_->grab_energy();
    tool_work_ += after - before;
    resting_.grab = after;
    if (grabs.empty() && !grabs_.empty())
        swing_.let_go(back_end_->body(), resting_.elastic + resting_.tether);
    grabs_.assign(grabs.begin(), grabs.end());
    wake();
    if (!region_) return;
    std::vector<int> held;
    const int vertices = back_end_->body().vertex_count;
    for (const Grab& grab : grabs)
        for (const int v : grab.vertices)
            if (v >= 0 && v < vertices) held.push_back(v);
    if (region_->hold(held)) change_region();
}

void GovernedStepper::set_tool(const std::optional<Tool>& tool) {
    if (!tool && !back_end_->tool()) return;
    if (tool) validate_tool(*tool, !back_end_->body().surface.empty());
    const std::optional<Tool> previous = back_end_->tool();
    const double before = back_end_->contact_energy();
    back_end_->set_tool(tool);
    const bool in_body = !back_end_->free_of_tool(back_end_->state().positions_mm);
    if (in_body || back_end_->tool_in_obstacle()) {
        back_end_->set_tool(previous);
        throw InputError(in_body ? "would stand in the body" : "would stand in an obstacle",
                         "the tool", "Put it beside the vessels");
    }
    const double after = back_end_->contact_energy();
    tool_work_ += after - before;
    resting_.contact = after;
    tool_load_ = {};
    tool_led_ = tool.has_value();
    if (!tool) swing_.let_go(back_end_->body(), resting_.elastic + resting_.tether);
    wake();
    // What leaned on the previous tool has lost its support and must be live.
    if (!region_ || !previous) return;
    region_->wake_all();
    change_region();
}

template <class Change>
void GovernedStepper::change_tool_goal(const Change& change) {
    if (!tool()) return;
    Tool led = *tool();
    change(led);
    validate_tool(led, true);
    back_end_->set_tool(led);
    tool_led_ = true;
    wake();
}

void GovernedStepper::lead_tool(const Vec3& target_mm) {
    change_tool_goal([&](Tool& tool) { tool.target_mm = target_mm; });
}

void GovernedStepper::turn_tool(const Vec3& by_rad) {
    change_tool_goal([&](Tool& tool) { tool.turn_rad = turned_after(tool.turn_rad, by_rad); });
}

void GovernedStepper::open_tool(double opening_mm) {
    change_tool_goal([&](Tool& tool) { tool.opening_target_mm = opening_mm; });
}

// Wakes frozen nodes that a moving surface touches, because a frozen node cannot give way.
void GovernedStepper::wake_touched() {
    if (!region_) return;
    std::vector<int> touched;
    for (const auto& [a, b] : back_end_->touching_nodes()) {
        if (region_->restless(a) && !region_->live(b)) touched.push_back(b);
        if (region_->restless(b) && !region_->live(a)) touched.push_back(a);
    }
    if (!touched.empty() && region_->wake(touched)) change_region();
}

void GovernedStepper::wake_near_tool() {
    if (region_ && region_->wake(back_end_->vertices_near_tool())) change_region();
}

// The body stands still meanwhile; the contact energy that this creates is work of the tool.
void GovernedStepper::lead_tool_for(double dt_s, double share) {
    const double before = back_end_->contact_energy();
    back_end_->lead_tool(share, dt_s);
    const double after = back_end_->contact_energy();
    tool_work_ += after - before;
    resting_.contact = after;
}

void GovernedStepper::set_gravity(const Vec3& gravity_mm_per_s2) {
    validate_gravity(gravity_mm_per_s2);
    if (gravity_mm_per_s2 == gravity_mm_per_s2_) return;
    gravity_mm_per_s2_ = gravity_mm_per_s2;
    back_end_->set_gravity(gravity_mm_per_s2);
    wake();
    if (!region_) return;
    region_->wake_all();
    change_region();
}

bool GovernedStepper::set_options(const StepperOptions& options) {
    validated(description_, options);
    if (options.order != options_.order) return false;
    if (!back_end_->set_options(options)) {
        std::unique_ptr<StepBackEnd> other = make_(description_, options);
        if (tearing_) follow_tear(*other);
        other->set_gravity(gravity_mm_per_s2_);
        other->set_grabs(grabs_);
        other->set_state(back_end_->state());
        other->set_tool(back_end_->tool());
        other->set_overlaps(back_end_->overlaps());
        if (region_) other->freeze(frozen_nodes());
        back_end_ = std::move(other);
        stress_pa_.clear();  // of the other element model, where nothing moves either
        if (options.model != options_.model) find_resting_energies();
    }
    options_ = options;
    return true;
}

// What sleeps is not woken by another element model, which stores other energies where it lies.
void GovernedStepper::find_resting_energies() {
    const EnergyLedger now = back_end_->energies();
    resting_.kinetic = now.kinetic;
    resting_.elastic = now.elastic;
    resting_.grab = now.grab;
    resting_.tether = now.tether;
    resting_.contact = now.contact;
    resting_.cohesion = now.cohesion;
}

std::span<const Vec3> GovernedStepper::positions_mm() const {
    return std::span(back_end_->state().positions_mm).first(back_end_->body().vertex_count);
}

std::span<const Vec3> GovernedStepper::velocities_mm_per_s() const {
    return std::span(back_end_->state().velocities_mm_per_s).first(back_end_->body().vertex_count);
}

EnergyLedger GovernedStepper::energies() const {
    EnergyLedger now = back_end_->energies();
    now.tool_work = tool_work_;
    return now;
}

// What is frozen away from its place at rest swings back, too; the rest need not be computed.
void GovernedStepper::wake_displaced() {
    if (!region_) return;
    const Body& body = back_end_->body();
    const std::vector<Vec3>& now = back_end_->state().positions_mm;
    const double displaced_mm = displaced_edges * body.mean_edge_mm;
    std::vector<int> displaced;
    for (int v = 0; v < body.vertex_count; ++v)
        if ((now[v] - body.rest_positions_mm[v]).squaredNorm() > displaced_mm * displaced_mm)
            displaced.push_back(v);
    if (!displaced.empty() && region_->wake(displaced)) change_region();
}

// All substeps of a step.
StepReport GovernedStepper::advance(double dt_s, const std::stop_token& stop,
                                    const PartDone& part_done) {
    if (!free()) swing_.hold();
    const int swinging =
        options_.published ? 1 : swing_.count(back_end_->body(), dt_s, options_.swing_substeps);
    const int substeps = std::max(options_.substeps, swinging);
    if (swinging > 1) wake_displaced();
    const std::vector<Vec3> before =
        swing_.swings() ? back_end_->state().velocities_mm_per_s : std::vector<Vec3>{};
    const double part_s = dt_s / substeps;
    StepReport report;
    for (int s = 0; s < substeps; ++s) {
        if (tool()) lead_tool_for(part_s, 1.0 / (substeps - s));
        const StepReport part = back_end_->advance(part_s, stop);
        report = s == 0 ? part : in_sequence(report, part);
        if (part_done && s + 1 < substeps) part_done((s + 1.0) / substeps);
    }
    if (swing_.swings()) swing_.watch(back_end_->body(), before, back_end_->state(), swinging);
    return report;
}

StepReport GovernedStepper::step(double dt_s, const std::stop_token& stop,
                                 const PartDone& part_done) {
    validate_time_step(dt_s);
    StepReport report;
    if (tool_led_) wake_near_tool();
    wake_touched();
    const bool sleeps = asleep();
    if (sleeps) {
        if (tool_led_) {
            lead_tool_for(dt_s, 1.0);
            tool_load_ = back_end_->tool_load();
        }
        report.dt_s = dt_s;
        report.asleep = !tool_led_;
        report.energy.kinetic = resting_.kinetic;
        report.energy.elastic = resting_.elastic;
        report.energy.grab = resting_.grab;
        report.energy.tether = resting_.tether;
        report.energy.contact = resting_.contact;
        report.energy.cohesion = resting_.cohesion;
        if (tearing_) report.tear = tearing_->report();
        report.tool = tool_load_;
        report.self = self_load_;
        report.obstacles = obstacle_load_;
    } else {
        report = advance(dt_s, stop, part_done);
    }
    report.energy.tool_work += std::exchange(tool_work_, 0.0);
    const double lost_before = std::exchange(lost_, 0.0);
    tool_led_ = tool() && tool()->speed_mm_per_s() >= slow_mm_per_s();
    if (!sleeps) {
        look_for_inversion(dt_s, report);
        if (tearing_) tear(report);
        tool_load_ = report.tool;
        self_load_ = report.self;
        obstacle_load_ = report.obstacles;
        resting_ = report.energy;
        watch(dt_s, report);
    }
    report.energy.integrator_loss += lost_before;
    return report;
}

double GovernedStepper::slow_mm_per_s() const {
    return sleep_speed_edges_per_s * back_end_->body().mean_edge_mm;
}

// The kinetic energy of nodes that freeze after this step is booked in this step's report.
void GovernedStepper::watch(double dt_s, StepReport& report) {
    if (!region_) {
        const bool still = !tool_led_ && fastest(back_end_->state()) < slow_mm_per_s();
        still_s_ = still ? still_s_ + dt_s : 0.0;
        return;
    }
    if (!region_->watch(positions_mm(), velocities_mm_per_s(), dt_s)) return;
    change_region();
    const double loss = std::exchange(lost_, 0.0);
    report.energy.kinetic -= loss;
    report.energy.integrator_loss += loss;
}

// Searches once after the body has settled, and again only after it has moved.
void GovernedStepper::look_for_inversion(double dt_s, StepReport& report) {
    if (options_.published) return;
    const double slow = settled_speed_edges_per_s * back_end_->body().mean_edge_mm;
    const double before = settled_s_;
    settled_s_ = fastest(back_end_->state()) < slow ? settled_s_ + dt_s : 0.0;
    if (before >= settled_after_s || settled_s_ < settled_after_s) return;
    if (!back_end_->recover_from_inversion(report)) return;
    wake();
    if (!region_) return;
    region_->wake_all();
    change_region();
}

void GovernedStepper::set_tear(const TearState& state) {
    if (!tearing_) return;
    tearing_->restore(state);
    stress_pa_.clear();
    follow_tear(*back_end_);
    std::erase_if(grabs_, [&](const Grab& grab) { return holds_beyond(grab, nodes()); });
    wake();
    if (!region_) return;
    region_ = new_region(region_->options());
    region_->follow_split(tearing_->topology().parents());
}

void GovernedStepper::set_state(std::span<const Vec3> positions_mm,
                                std::span<const Vec3> velocities_mm_per_s) {
    const Body& body = back_end_->body();
    const bool every_node = positions_mm.size() == nodes();
    validate_state(positions_mm, velocities_mm_per_s, every_node ? nodes() : body.vertex_count);
    BodyState state = back_end_->state();
    std::ranges::copy(positions_mm, state.positions_mm.begin());
    std::ranges::copy(velocities_mm_per_s, state.velocities_mm_per_s.begin());
    for (std::size_t m = 0; !every_node && m < body.edge_of_middle_node.size(); ++m) {
        const auto& [a, b] = body.edge_of_middle_node[m];
        const std::size_t i = body.vertex_count + m;
        state.positions_mm[i] = 0.5 * (positions_mm[a] + positions_mm[b]);
        state.velocities_mm_per_s[i] = 0.5 * (velocities_mm_per_s[a] + velocities_mm_per_s[b]);
    }
    for (std::size_t i = 0; i < nodes(); ++i)
        if (body.fixed[i]) state.velocities_mm_per_s[i].setZero();
    if (!back_end_->free_of_tool(state.positions_mm))
        throw InputError("puts the body into the tool", "the state", "Take the tool away first");
    back_end_->set_state(state);
    swing_.hold();
    tool_work_ = 0.0;
    lost_ = 0.0;
    wake();
    if (!region_) return;
    region_->wake_all();
    change_region();
}

LiveRegion GovernedStepper::new_region(const LiveRegionOptions& options) const {
    LiveRegion region(description_.skeleton, description_.mesh.vertices_mm, options);
    for (const auto& nodes : description_.mesh.tetrahedra) region.connect(nodes);
    for (const auto& nodes : description_.hexahedra) region.connect(nodes);
    return region;
}

LiveStepper::Extent GovernedStepper::extent() const {
    Extent extent;
    for (const ElementGroup& group : back_end_->body().groups) extent.elements += group.size();
    extent.vertices = back_end_->body().vertex_count;
    extent.live_elements = back_end_->live_elements();
    for (int v = 0; v < extent.vertices; ++v)
        extent.live_vertices += !region_ || region_->live(v) ? 1 : 0;
    return extent;
}

std::unique_ptr<LiveStepper> make_live_stepper(const BodyDescription& body,
                                               const StepperOptions& options,
                                               const LiveRegionOptions& region) {
    return std::make_unique<GovernedStepper>(body, options, region, make_cpu_back_end);
}

std::unique_ptr<Stepper> make_cpu_stepper(const BodyDescription& body,
                                          const StepperOptions& options) {
    return std::make_unique<GovernedStepper>(body, options, std::nullopt, make_cpu_back_end);
}

}  // namespace hepatica
