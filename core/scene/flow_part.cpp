// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/flow_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/base/number_text.h"

namespace hepatica {
namespace {

// Gives the vertices of a changed body their parents' values. Returns false where nothing is to be
// changed.
template <class T>
bool inherit_shared(const BodyTopology& topology, bool changed,
                    std::shared_ptr<const std::vector<T>>& per_vertex) {
    if (!per_vertex || (!changed && per_vertex->size() == topology.vertex_count())) return false;
    auto inherited = std::make_shared<std::vector<T>>(*per_vertex);
    inherit(topology, *inherited);
    per_vertex = std::move(inherited);
    return true;
}

// The opening of a side that swings changes in every frame: what changes sooner than this share of
// the drug's run after the last change is taken together with what follows it.
constexpr double least_share_between_tears = 0.01;

// Whether a drug's flow is hardly another one: openings between a half and twice.
bool alike(const std::vector<ThroughTear>& a, const std::vector<ThroughTear>& b) {
    return std::ranges::equal(a, b, [](const ThroughTear& one, const ThroughTear& other) {
        const auto [least, most] = std::minmax(one.area_mm2, other.area_mm2);
        return one == other && most < 2.0 * least;
    });
}

// The places of the body before anything was split, which come first. Split vertices have their
// parents' times; counted as vertices of their own, they would move the end of the drug's clock, so
// that it depended on what was torn when the injection was computed.
std::shared_ptr<const std::vector<TreePoint>> of_whole_body(const std::vector<TreePoint>& places,
                                                            const BodyTopology& topology) {
    std::size_t whole = 0;
    while (whole < std::min(places.size(), topology.vertex_count()) &&
           topology.parent(static_cast<int>(whole)) == static_cast<int>(whole))
        ++whole;
    return std::make_shared<const std::vector<TreePoint>>(
        places.begin(), places.begin() + static_cast<std::ptrdiff_t>(whole));
}

// How many later tears both know, from the first on.
std::size_t times_in_common(const Injection& a, const Injection& b) {
    const auto ends =
        std::ranges::mismatch(a.later, b.later, {}, &TornSince::from_s, &TornSince::from_s);
    return static_cast<std::size_t>(ends.in1 - a.later.begin());
}

}  // namespace

FlowPart::FlowPart(const VesselTree& tree, const std::vector<VertexPlace>& places,
                   const FlowSpec& spec, const BodyTopology& topology)
    : tree_(tree), topology_(topology), followed_(topology.version()) {
    drug_.speed = spec.drug_speed;
    if (tree.segments.empty())
        throw InputError("the vessel tree has no segments", "", "Reconstruct the patient first");
    std::vector<TreePoint> on_tree;
    on_tree.reserve(places.size());
    for (const VertexPlace& place : places) on_tree.push_back(place.on_tree);
    places_ = std::make_shared<const std::vector<TreePoint>>(std::move(on_tree));
}

FlowPart::~FlowPart() {
    // All are cancelled before any is waited for.
    for (const auto& run : ended_) run->cancel();
    if (run_) run_->cancel();
}

void FlowPart::inject(const Injection& injection) {
    const InjectionOptions options = injection_options(injection, tree_);
    if (!flows_like_blood(options)) {
        auto run =
            std::make_unique<InjectionRun>(tree_, of_whole_body(*places_, topology_), injection);
        end_run();
        run_ = std::move(run);
        drug_.computing = true;
        return;
    }
    Job job;
    DrugArrival arrival = drug_arrival(tree_, *of_whole_body(*places_, topology_), options, job);
    end_run();
    start(injection, std::move(arrival));
}

void FlowPart::follow_tears(const std::vector<ThroughTear>& tears) {
    if (!injected_ || !drug_.playing || (run_ && !updating_) || steps_left_ > 0) return;
    if (drug_.time_s >= drug_.end_s) return;
    const Injection& known = updating_ ? run_->injection() : *injected_;
    if (alike(known.last_tears(), tears)) return;
    if (!known.later.empty()) {
        const double since_s = drug_.time_s - known.later.back().from_s;
        if (since_s > 0.0 && since_s < least_share_between_tears * drug_.end_s) return;
    }
    Injection now = known;
    // Where the clock was turned back, what tore after it has not happened yet.
    std::erase_if(now.later,
                  [this](const TornSince& later) { return later.from_s >= drug_.time_s; });
    now.later.push_back({drug_.time_s, tears});
    now.least_end_s = drug_.end_s;
    const InjectionOptions options = injection_options(now, tree_);
    follow_topology();
    auto run = std::make_unique<InjectionRun>(tree_, of_whole_body(*places_, topology_), now);
    end_run();
    run_ = std::move(run);
    updating_ = drug_.computing = true;
    if (flows_like_blood(options)) steps_left_ = steps_to_update();
    drug_.arrival_s = std::make_shared<const std::vector<float>>(
        without_cut_off(*drug_.arrival_s, now, now.later.size() - 1));
    ++drug_.version;
}

// 0.1 s of steps for 500 segments, through which a front runs in half of that (see
// docs/tearing.md); its work grows with their square.
int FlowPart::steps_to_update() const {
    constexpr double least = 6.0, of_segments = 500.0;
    const double share = static_cast<double>(tree_.segments.size()) / of_segments;
    return static_cast<int>(std::ceil(least * std::max(1.0, share * share)));
}

// Without what is cut off by the tears of the injection from this one on.
std::vector<float> FlowPart::without_cut_off(std::vector<float> arrival_s,
                                             const Injection& injection, std::size_t known) const {
    const InjectionOptions options = injection_options(injection, tree_);
    for (std::size_t k = known; k < options.later_tears.size(); ++k)
        cut_off(tree_, *places_, options, options.later_tears[k], arrival_s);
    return arrival_s;
}

void FlowPart::finish_injection(const std::stop_token& stop) {
    if (!run_) return;
    const std::unique_ptr<InjectionRun> run = std::move(run_);
    const bool updates = std::exchange(updating_, false);
    drug_.computing = false;
    steps_left_ = 0;
    const std::stop_callback told(stop, [&run] { run->cancel(); });
    DrugArrival arrival;
    try {
        arrival = run->take();
    } catch (const InputError&) {
        // Otherwise the same would be begun again in the next step.
        if (updates) play(false);
        throw;
    }
    // The outcome does not depend on whether the run or the stop was faster.
    if (stop.stop_requested()) throw Cancelled();
    if (updates)
        show(run->injection(), std::move(arrival));
    else
        start(run->injection(), std::move(arrival));
}

void FlowPart::start(const Injection& injection, DrugArrival arrival) {
    keep_reached();
    ++drug_.injections;
    drug_.time_s = 0.0;
    drug_.playing = true;
    show(injection, std::move(arrival));
}

// Clock and count are left as they are.
void FlowPart::show(const Injection& injection, DrugArrival arrival) {
    injected_ = injection;
    mass_error_relative_ = arrival.mass_error_relative;
    at_tears_s_ = std::move(arrival.at_tears_s);
    drug_.arrival_s = std::move(arrival.arrival_s);
    drug_.injection = std::make_shared<const InjectionOptions>(injection_options(injection, tree_));
    ++drug_.version;
    drug_.end_s = std::max(arrival.end_s, injection.least_end_s);
    follow_topology();
}

// What the injection that is shown has reached stays visible beside the next.
void FlowPart::keep_reached() {
    if (!drug_.arrival_s) return;
    const std::vector<float>& arrival_s = *drug_.arrival_s;
    std::vector<std::uint8_t> reached;
    if (drug_.reached_before) reached = *drug_.reached_before;
    reached.resize(arrival_s.size(), 0);
    for (std::size_t v = 0; v < arrival_s.size(); ++v)
        if (arrival_s[v] <= static_cast<float>(drug_.time_s)) reached[v] = 1;
    drug_.reached_before = std::make_shared<const std::vector<std::uint8_t>>(std::move(reached));
}

// A cancelled run may still be within a step of its front; it is not waited for here.
void FlowPart::end_run() {
    drop_ended_runs();
    drug_.computing = updating_ = false;
    steps_left_ = 0;
    if (!run_) return;
    run_->cancel();
    ended_.push_back(std::move(run_));
}

void FlowPart::drop_ended_runs() {
    ended_.remove_if([](const auto& run) { return run->ready(); });
}

// Vertices that were split off have the place and the arrival time of their parents.
void FlowPart::follow_topology() {
    const bool changed =
        topology_.version() != followed_ || places_->size() != topology_.vertex_count();
    if (changed) {
        auto places = std::make_shared<std::vector<TreePoint>>(*places_);
        inherit(topology_, *places);
        places_ = std::move(places);
    }
    if (inherit_shared(topology_, changed, drug_.arrival_s)) ++drug_.version;
    inherit_shared(topology_, changed, drug_.reached_before);
    followed_ = topology_.version();
}

void FlowPart::remove_drug() {
    end_run();
    injected_.reset();
    drug_.arrival_s.reset();
    drug_.injection.reset();
    drug_.reached_before.reset();
    ++drug_.version;
    drug_.time_s = 0.0;
    drug_.end_s = 0.0;
    drug_.playing = false;
}

void FlowPart::set_time(double time_s) {
    if (!(time_s >= 0.0) || !std::isfinite(time_s))
        throw InputError("is " + number_text(time_s), "time of the drug", "Give 0 s or more");
    drug_.time_s = time_s;
}

void FlowPart::set_speed(double factor) {
    if (!(factor > 0.0) || !std::isfinite(factor))
        throw InputError("is " + number_text(factor), "speed of the drug", "Give more than 0");
    drug_.speed = factor;
}

void FlowPart::step(double dt_s, const std::stop_token& stop) {
    follow_topology();
    drop_ended_runs();
    show_what_is_due(stop);
    if (!drug_.playing) return;
    const double next_s = drug_.time_s + drug_.speed * dt_s;
    // The flow that is still to be shown may end later.
    drug_.playing = next_s < drug_.end_s || steps_left_ > 0;
    // A time beyond the end that was set by hand is kept.
    drug_.time_s = drug_.playing ? next_s : std::max(drug_.time_s, drug_.end_s);
}

void FlowPart::show_what_is_due(const std::stop_token& stop) {
    if (steps_left_ == 0 || --steps_left_ > 0) return;
    try {
        finish_injection(stop);
    } catch (const InputError&) {
        // The clock stands now: nothing flows any more.
    }
}

FlowCheckpoint FlowPart::checkpoint() const {
    FlowCheckpoint checkpoint;
    checkpoint.injected = injected_;
    if (run_) checkpoint.computing = run_->injection();
    checkpoint.updating = updating_;
    checkpoint.steps_left = steps_left_;
    checkpoint.time_s = drug_.time_s;
    checkpoint.playing = drug_.playing;
    checkpoint.speed = drug_.speed;
    checkpoint.arrival = {drug_.arrival_s, drug_.end_s, mass_error_relative_, at_tears_s_};
    checkpoint.options = drug_.injection;
    checkpoint.injections = drug_.injections;
    checkpoint.reached_before = drug_.reached_before;
    return checkpoint;
}

void FlowPart::restore(const FlowCheckpoint& checkpoint) {
    require_place(checkpoint.injected);
    require_place(checkpoint.computing);
    const bool updating = checkpoint.updating && checkpoint.injected && checkpoint.computing;
    DrugArrival arrival = checkpoint.arrival;
    if (checkpoint.injected && !arrival.arrival_s) {
        Job job;
        arrival = drug_arrival(tree_, *of_whole_body(*places_, topology_),
                               injection_options(*checkpoint.injected, tree_), job);
        arrival.end_s = std::max(arrival.end_s, checkpoint.injected->least_end_s);
        if (updating)
            arrival.arrival_s = std::make_shared<const std::vector<float>>(
                without_cut_off(*arrival.arrival_s, *checkpoint.computing,
                                times_in_common(*checkpoint.injected, *checkpoint.computing)));
    }
    std::unique_ptr<InjectionRun> run;
    if (checkpoint.computing)
        run = std::make_unique<InjectionRun>(tree_, of_whole_body(*places_, topology_),
                                             *checkpoint.computing);
    set_time(checkpoint.time_s);
    set_speed(checkpoint.speed);
    end_run();
    run_ = std::move(run);
    updating_ = updating;
    steps_left_ = updating ? checkpoint.steps_left : 0;
    injected_ = checkpoint.injected;
    drug_.injection = checkpoint.options;
    if (checkpoint.injected && !drug_.injection)
        drug_.injection = std::make_shared<const InjectionOptions>(
            injection_options(*checkpoint.injected, tree_));
    drug_.injections = checkpoint.injections;
    drug_.reached_before = checkpoint.reached_before;
    mass_error_relative_ = arrival.mass_error_relative;
    at_tears_s_ = std::move(arrival.at_tears_s);
    drug_.computing = run_ != nullptr;
    drug_.arrival_s = std::move(arrival.arrival_s);
    drug_.end_s = arrival.end_s;
    ++drug_.version;
    play(checkpoint.playing);
    follow_topology();
}

float FlowPart::arrival_at_stump_s(const ThroughTear& tear, int vertex) const {
    if (injected_)
        for (std::size_t i = 0; i < at_tears_s_.size(); ++i)
            if (injected_->last_tears()[i] == tear) return at_tears_s_[i];
    // Vertices that were split off in this step have no arrival time yet.
    const bool known = vertex >= 0 && drug_.arrival_s &&
                       static_cast<std::size_t>(vertex) < drug_.arrival_s->size();
    return known ? (*drug_.arrival_s)[vertex] : std::numeric_limits<float>::infinity();
}

void FlowPart::require_place(const std::optional<Injection>& injection) const {
    if (!injection) return;
    require_segment(injection->at.segment);
    for (const ThroughTear& tear : injection->tears) require_segment(tear.at.segment);
    for (const TornSince& later : injection->later)
        for (const ThroughTear& tear : later.tears) require_segment(tear.at.segment);
}

void FlowPart::require_segment(int segment) const {
    if (segment < 0 || static_cast<std::size_t>(segment) >= tree_.segments.size())
        throw InputError("injects into segment " + std::to_string(segment) + ", which is not there",
                         "checkpoint", "Give a checkpoint of the same patient");
}

std::uint64_t FlowPart::state_hash() const {
    Hasher hasher;
    const auto add_tears = [&hasher](const std::vector<ThroughTear>& tears) {
        for (const ThroughTear& tear : tears) {
            const std::array<double, 2> cut{tear.at.arclength_mm, tear.area_mm2};
            hasher.add_bytes(&tear.at.segment, sizeof tear.at.segment);
            hasher.add(std::span<const double>(cut));
            if (tear.side) hasher.add_bytes(&tear.side, sizeof tear.side);
        }
    };
    const auto add = [&hasher, &add_tears](const Injection* injection) {
        const int segment = injection != nullptr ? injection->at.segment : -1;
        hasher.add_bytes(&segment, sizeof segment);
        if (injection == nullptr) return;
        const std::array<double, 4> numbers{injection->at.arclength_mm, injection->mass_flow_g_s,
                                            injection->void_fraction,
                                            injection->drug_viscosity_pa_s};
        hasher.add(std::span<const double>(numbers));
        for (const std::string& name : {injection->second_phase, injection->pressure_model})
            hasher.add_bytes(name.c_str(), name.size() + 1);
        add_tears(injection->tears);
        for (const TornSince& later : injection->later) {
            const std::array<double, 2> since{later.from_s, injection->least_end_s};
            hasher.add(std::span<const double>(since));
            add_tears(later.tears);
        }
    };
    add(injected_ ? &*injected_ : nullptr);
    add(run_ ? &run_->injection() : nullptr);
    if (updating_) hasher.add_bytes(&updating_, sizeof updating_);
    if (steps_left_ > 0) hasher.add_bytes(&steps_left_, sizeof steps_left_);
    const std::array<double, 3> clock{drug_.time_s, drug_.speed, drug_.playing ? 1.0 : 0.0};
    hasher.add(std::span<const double>(clock));
    return hasher.value();
}

}  // namespace hepatica
