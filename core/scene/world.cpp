// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/world.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/base/patient_space.h"
#include "core/scene/bleeding.h"
#include "core/scene/deform_part.h"
#include "core/scene/flow_part.h"
#include "core/scene/heap_use.h"
#include "core/scene/leak_places.h"
#include "core/scene/obstacles_of_organs.h"
#include "core/scene/origins_of.h"
#include "core/scene/world_checkpoint.h"

namespace hepatica {

namespace {

double milliseconds_of(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::milli> passed =
        std::chrono::steady_clock::now() - start;
    return passed.count();
}

PartCost cost_of(const std::string& name, const std::function<void()>& build) {
    PartCost cost{name};
    const std::size_t before = heap_bytes_in_use();
    cost.build_ms = milliseconds_of(build);
    const std::size_t after = heap_bytes_in_use();
    cost.bytes = after > before ? after - before : 0;
    return cost;
}

}  // namespace

World::World(std::shared_ptr<const PatientCase> patient, const SceneSpec& spec, Job& job,
             const DeformBackEnd& back_end)
    : patient_(std::move(patient)), spec_(spec) {
    job.begin_stage("Building the scene");
    parts_.push_back(cost_of("shape", [&] {
        if (spec_.deform)
            topology_.emplace(patient_->mesh.vertices_mm.size(),
                              boundary_triangles(patient_->mesh));
        else
            topology_.emplace(patient_->surface.vertices_mm.size(), patient_->surface.triangles);
    }));
    job.advance(0.1);
    surfaces_of_obstacles_ =
        cost_of("obstacles", [&] { obstacles_ = obstacles_for(*patient_, spec_.contact); });
    if (spec_.deform)
        parts_.push_back(cost_of("deform", [&] {
            deform_ = std::make_unique<DeformPart>(*patient_, *spec_.deform, DeformPart::region,
                                                   back_end, spec_.contact, spec_.tear, obstacles_);
        }));
    list_contact();
    job.advance(0.8);
    if (spec_.flow)
        parts_.push_back(cost_of("flow", [&] {
            flow_ = std::make_unique<FlowPart>(
                patient_->tree,
                deform_ ? deform_->places() : places_of(rest_positions_mm(), patient_->tree),
                *spec_.flow, *topology_);
        }));
    job.advance(1.0);
}

World::~World() = default;

// These parts are built with the body; their costs are known from the first step on.
void World::list_contact() {
    std::erase_if(parts_, [](const PartCost& part) {
        return part.name == "self-contact" || part.name == "obstacles";
    });
    if (!deform_) return;
    const auto behind = [this] { return std::ranges::find(parts_, "deform", &PartCost::name) + 1; };
    if (deform_->body().obstacles) parts_.insert(behind(), surfaces_of_obstacles_);
    if (deform_->body().self) parts_.insert(behind(), PartCost{.name = "self-contact"});
}

std::shared_ptr<const Obstacles> World::known_obstacles() {
    if (!obstacles_)
        surfaces_of_obstacles_ = cost_of("obstacles", [this] {
            obstacles_ = obstacles_for(*patient_, ContactSpec{.obstacles = WantedObstacles::known});
        });
    return obstacles_;
}

bool World::use_contact(bool self, bool obstacles, double friction) {
    const std::shared_ptr<const Obstacles> there = obstacles ? known_obstacles() : nullptr;
    deform_->set_contact(self ? std::optional(friction) : std::nullopt, there);
    list_contact();
    follow_tear();
    return !obstacles || there != nullptr;
}

const std::vector<Vec3>& World::rest_positions_mm() const {
    return deform_ ? deform_->rest_positions_mm() : patient_->surface.vertices_mm;
}

std::size_t World::vertex_count() const {
    return rest_positions_mm().size();
}

Vec3 World::vertex_mm(int vertex) const {
    return deform_ ? deform_->positions_mm()[vertex] : rest_positions_mm()[vertex];
}

PartCost* World::part(const std::string& name) {
    const auto found = std::ranges::find(parts_, name, &PartCost::name);
    return found != parts_.end() ? &*found : nullptr;
}

// Takes the cost of contact out of the deforming body's; `before`: the part's cost without it.
void World::part_out(const std::string& name, const PartCost& before, const SelfCost& cost) {
    PartCost* const own = part(name);
    if (own == nullptr) return;
    if (cost.bytes > 0) own->bytes = before.bytes + cost.bytes;
    if (cost.build_ms > 0.0) own->build_ms = before.build_ms + cost.build_ms;
    own->frame_ms = cost.step_ms;
    part("deform")->frame_ms -= cost.step_ms;
}

StepReport World::step(const std::stop_token& stop, const Stepper::PartDone& part_done) {
    StepReport report;
    report.dt_s = spec_.dt_s;
    for (PartCost& part : parts_) {
        if (part.name == "deform")
            part.frame_ms = milliseconds_of([&] {
                // A setting that was changed since has a stepper of its own, which counts its
                // versions anew and could come to the number of the last one.
                const TornTopology* torn = deform_->torn();
                if (torn != nullptr && torn->version() != torn_version_) follow_tear();
                report = deform_->step(spec_.dt_s, stop, part_done);
                follow_tear();
            });
        else if (part.name == "flow")
            part.frame_ms = milliseconds_of([&] {
                flow_->follow_tears(bleeding_ ? bleeding_->tears() : std::vector<ThroughTear>{});
                flow_->step(spec_.dt_s, stop);
            });
    }
    press();
    if (bleeding_) {
        bleeding_->step(spec_.dt_s);
        const DrugLeak drug = drug_leak_now();
        bleeding_->leak_drug(drug.total_g_s * spec_.dt_s, drug.shares);
    }
    part_out("self-contact", {}, report.self_cost);
    part_out("obstacles", surfaces_of_obstacles_, report.obstacle_cost);
    time_s_ += spec_.dt_s;
    return report;
}

// Vessels are torn only when joints part or come apart; how far their sides are open changes as
// they move.
bool World::bleed() {
    if (!deform_ || !deform_->tears()) {
        bleeding_.reset();
        searched_ = {};
        torn_ = {};
        return false;
    }
    if (!bleeding_) bleeding_ = std::make_unique<Bleeding>(patient_->tree);
    const auto torn = std::exchange(searched_, deform_->torn_so_far());
    const bool same = torn == searched_;
    if (same && torn_.sides.empty()) return false;
    if (!same) torn_ = deform_->torn_places(patient_->tree);
    // Made whole, no vessel shows where it bled.
    if (!same && searched_.joints_broken == 0) bleeding_->set_pools({});
    const std::vector<ThroughTear> before = bleeding_->tears();
    bleeding_->set_tears(open_now(torn_));
    return bleeding_->tears() != before;
}

std::vector<ThroughTear> World::torn_now() {
    if (!deform_ || !deform_->tears()) return {};
    return open_now(deform_->torn_places(patient_->tree));
}

// A side whose lips have closed is held open by the blood within, as far as it is slit.
std::vector<ThroughTear> World::open_now(const TornPlaces& torn) const {
    return open_tears(torn, deform_->positions_mm(), [this](int segment, double length_mm) {
        const VesselSegment& vessel = patient_->tree.segments[static_cast<std::size_t>(segment)];
        return slit_mm2(length_mm, resting_pressure_pa(vessel.system), wall());
    });
}

TubeWall World::wall() const {
    return {.young_modulus_pa = deform_->body().material.young_modulus_pa};
}

// Pressed vessels bleed less.
void World::press() {
    if (!bleeding_ || bleeding_->tears().empty()) return;
    bleeding_->set_pressed(deform_->pressed(), wall());
}

// Where blood lies on the body as topology_ has it.
void World::find_pools() {
    leaking_.clear();
    if (!bleeding_ || !tear_view_.rims) return;
    std::vector<ThroughTear> ends;
    for (const BloodPool& pool : bleeding_->pools()) ends.push_back(pool.of);
    leaking_ = leaking_vertices(patient_->tree, ends, tear_view_, patient_->mesh.vertices_mm,
                                *topology_->triangles());
}

void World::follow_tear() {
    const bool parted = bleed();
    const TornTopology* torn = deform_ ? deform_->torn() : nullptr;
    const std::uint64_t version = torn != nullptr ? torn->version() : 1;
    const bool split = version != std::exchange(torn_version_, version);
    if (split) {
        tear_view_ = {};
        leaking_.clear();
        if (torn != nullptr) {
            topology_->become({torn->parents().begin(), torn->parents().end()}, torn->surface());
            tear_view_.origins = std::make_shared<const std::vector<int>>(origins_of(*torn));
            tear_view_.bare = std::make_shared<const std::vector<std::uint8_t>>(torn->bare_faces());
        } else {
            std::vector<int> whole(patient_->mesh.vertices_mm.size());
            std::iota(whole.begin(), whole.end(), 0);
            topology_->become(std::move(whole), boundary_triangles(patient_->mesh));
        }
    }
    // Split vertices come apart later: the rims may change without a split.
    const auto rims_before = tear_view_.rims;
    if (torn != nullptr) deform_->show_tear(tear_view_);
    // A vessel may be torn through without a new rim: all of them were there before.
    if (tear_view_.rims != rims_before || parted) find_pools();
}

void World::reset() {
    if (deform_) {
        deform_->release();
        deform_->remove_tool();
        deform_->mend();
        const std::vector<Vec3>& rest = deform_->rest_positions_mm();
        deform_->set_state({rest, std::vector<Vec3>(rest.size(), Vec3::Zero())});
    }
    follow_tear();
    if (bleeding_) {
        bleeding_->set_leaked_g(0.0);
        bleeding_->set_leaked_drug_g(0.0);
    }
    if (flow_) flow_->remove_drug();
}

TreePoint World::place_near(const Vec3& point_mm) const {
    require_reachable(point_mm, "the point");
    // The vertices keep their places on the tree as they move.
    if (!flow_) return nearest_point(patient_->tree, point_mm);
    int nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t v = 0; v < vertex_count(); ++v) {
        const double distance = (vertex_mm(static_cast<int>(v)) - point_mm).squaredNorm();
        if (distance >= least) continue;
        least = distance;
        nearest = static_cast<int>(v);
    }
    return flow_->place_of(nearest);
}

DrugLeak World::drug_leak_now() const {
    if (!bleeding_ || !flow_) return {};
    std::vector<float> arrival_s;
    const std::vector<ThroughTear>& tears = bleeding_->tears();
    for (std::size_t i = 0; i < std::min(leaking_.size(), tears.size()); ++i)
        arrival_s.push_back(flow_->arrival_at_stump_s(tears[i], leaking_[i]));
    return drug_leak(flow_->drug(), arrival_s, bleeding_->leaks_g_s());
}

void World::show_leaks(TearView& tear, const std::vector<float>& positions_mm) const {
    const std::vector<double> shares = bleeding_->shares_of_loss();
    for (std::size_t i = 0; i < std::min(leaking_.size(), shares.size()); ++i) {
        if (leaking_[i] < 0 || shares[i] <= 0.0) continue;
        const float* at = &positions_mm[3 * static_cast<std::size_t>(leaking_[i])];
        tear.leaks.push_back({Vec3(at[0], at[1], at[2]), shares[i], bleeding_->pools()[i].drug_g});
    }
}

void World::fill(Frame& frame) const {
    frame.time_s = time_s_;
    frame.topology_version = topology_->version();
    frame.surface = topology_->triangles();
    frame.positions_mm.resize(3 * vertex_count());
    const Vec3* positions = deform_ ? deform_->positions_mm().data() : rest_positions_mm().data();
    for (std::size_t v = 0; v < vertex_count(); ++v)
        for (int axis = 0; axis < 3; ++axis)
            frame.positions_mm[3 * v + axis] = static_cast<float>(positions[v][axis]);
    frame.grab = deform_ ? deform_->grab_view() : std::nullopt;
    frame.tool = deform_ ? deform_->tool_view() : std::nullopt;
    frame.obstacles = deform_ ? deform_->body().obstacles : nullptr;
    frame.self_friction = deform_ ? deform_->settings().self_friction : std::nullopt;
    frame.tear.reset();
    if (deform_ && deform_->tears()) {
        frame.tear = tear_view_;
        deform_->show_tear(*frame.tear);
        if (bleeding_) {
            frame.tear->leak_g_s = bleeding_->leak_g_s();
            frame.tear->leaked_g = bleeding_->leaked_g();
            frame.tear->leaked_drug_g = bleeding_->leaked_drug_g();
            const PressedLumen other = bleeding_->most_pressed(false);
            frame.tear->open_share = bleeding_->most_pressed(true).open_share;
            frame.tear->other_open_share = other.open_share;
            frame.tear->other_segment = other.segment;
            show_leaks(*frame.tear, frame.positions_mm);
        }
    }
    frame.drug = flow_ ? flow_->drug() : DrugView{};
}

WorldCheckpoint World::checkpoint() const {
    WorldCheckpoint checkpoint;
    checkpoint.time_s = time_s_;
    if (deform_) checkpoint.deform = deform_->checkpoint();
    if (flow_) checkpoint.flow = flow_->checkpoint();
    if (bleeding_) {
        checkpoint.leaked_g = bleeding_->leaked_g();
        checkpoint.leaked_drug_g = bleeding_->leaked_drug_g();
        for (const BloodPool& pool : bleeding_->pools())
            if (pool.lost_g > 0.0) checkpoint.pools.push_back(pool);
    }
    return checkpoint;
}

void World::restore(const WorldCheckpoint& checkpoint) {
    if (checkpoint.deform.has_value() != (deform_ != nullptr) ||
        checkpoint.flow.has_value() != (flow_ != nullptr))
        throw InputError("is of a scene with other parts", "checkpoint",
                         "Give a checkpoint of this scene");
    for (const BloodPool& pool : checkpoint.pools)
        if (pool.of.at.segment < 0 ||
            static_cast<std::size_t>(pool.of.at.segment) >= patient_->tree.segments.size())
            throw InputError(
                "bled from segment " + std::to_string(pool.of.at.segment) + ", which is not there",
                "checkpoint", "Give a checkpoint of the same patient");
    if (deform_) {
        const bool obstacles = checkpoint.deform->settings.obstacles;
        deform_->restore(*checkpoint.deform, obstacles ? known_obstacles() : nullptr);
        list_contact();
    }
    searched_ = {};
    // Other settings make another stepper, which counts its versions anew: the one that is restored
    // may have the number of the one before. Version 1 is always the whole body.
    if (torn_version_ != 1) torn_version_ = 0;
    follow_tear();
    press();
    if (bleeding_) {
        bleeding_->set_leaked_g(checkpoint.leaked_g);
        bleeding_->set_leaked_drug_g(checkpoint.leaked_drug_g);
        bleeding_->set_pools(checkpoint.pools);
        find_pools();
    }
    if (flow_) flow_->restore(*checkpoint.flow);
    time_s_ = checkpoint.time_s;
}

std::uint64_t World::state_hash() const {
    const std::array<std::uint64_t, 2> parts{deform_ ? deform_->state_hash() : 0,
                                             flow_ ? flow_->state_hash() : 0};
    Hasher hasher;
    hasher.add(std::span<const std::uint64_t>(parts));
    return hasher.value();
}

}  // namespace hepatica
