// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a world through which a drug flows: the injection, its clock, and the arrival times
// of the front at the vertices.
#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/mesh/body_topology.h"
#include "core/scene/drug_arrival.h"
#include "core/scene/frame.h"
#include "core/scene/injection_run.h"
#include "core/scene/scene_spec.h"
#include "core/scene/vertex_places.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// Everything that determines the part's next steps, apart from the case and the scene's spec.
struct FlowCheckpoint {
    std::optional<Injection> injected;
    std::optional<Injection> computing;
    bool updating = false;  // `computing` is `injected` as the vessels have torn since
    int steps_left = 0;     // until `computing` is shown; 0: when it is finished
    double time_s = 0.0;
    bool playing = false;
    double speed = 1.0;
    // The result of `injected`, so that going back costs nothing; computed again where it is empty,
    // as after reading from a file.
    DrugArrival arrival{};
    std::shared_ptr<const InjectionOptions> options{};  // of `injected`; empty as `arrival` is
    int injections = 0;                                 // so far, with `injected`
    std::shared_ptr<const std::vector<std::uint8_t>> reached_before{};  // as in DrugView
};

class FlowPart {
  public:
    // `places` are those of the vertices of `topology`, which must outlive the part; data per
    // vertex follow it. Throws InputError for an empty tree.
    FlowPart(const VesselTree& tree, const std::vector<VertexPlace>& places, const FlowSpec& spec,
             const BodyTopology& topology);
    ~FlowPart();  // cancels what is being computed

    // The vessels are full of blood, which rests except for the injection; every outlet has the
    // same pressure, and so has what is around the stumps of the injection's tears. A drug that
    // flows like blood is there at once, in O(segments + vertices); any other is computed on a
    // thread of its own, and the last injection stays until finish_injection(). Cancels what is
    // being computed. Throws InputError for values out of range and then changes nothing.
    void inject(const Injection& injection);
    // Tells what is torn now; call before each step. Where it is other than the injection knows, in
    // other places or by a factor of two of an opening, the drug's flow is computed anew from this
    // time on, on a thread of its own in O(segments^2 + vertices) for each change that the
    // injection knows; changes within a hundredth of the drug's run are taken together, so that
    // there are few. Until then the drug is shown as before but for what is cut off from the
    // catheter. The flow of a drug that flows like blood is shown by the step() that is
    // steps_to_update() later, whatever the machine's speed, and what tears until then is taken up
    // afterwards; that of any other drug by finish_injection(). Where no flow is found, the drug's
    // clock stops. Does nothing while it stands, or another injection is being computed.
    void follow_tears(const std::vector<ThroughTear>& tears);
    // Enough steps for the front of a drug that flows like blood to run through the tree meanwhile.
    int steps_to_update() const;
    // Whether an injection is being computed; whether it waits for finish_injection(), which then
    // does not wait where it is ready.
    bool computing() const { return run_ != nullptr; }
    bool waits_for_finish() const { return run_ != nullptr && steps_left_ == 0; }
    // The same where it is the one that is shown, after a tear.
    bool update_waits() const { return updating_ && waits_for_finish(); }
    bool injection_ready() const { return waits_for_finish() && run_->ready(); }
    // Replaces the last injection by the computed one, for which it waits, and starts the drug's
    // clock, or lets it run on where vessels have torn since. Does nothing where none is being
    // computed. Throws what the computation threw (InputError where nothing can flow; Cancelled
    // soon after a stop is requested); the last injection then stays, and where vessels have torn
    // since, an InputError stops its clock.
    void finish_injection(const std::stop_token& stop = {});
    // Removes the drug and cancels what is being computed.
    void remove_drug();
    // The clock runs until the drug's end_s and stops there.
    void play(bool playing) { drug_.playing = playing && drug_.arrival_s != nullptr; }
    void set_time(double time_s);   // >= 0, otherwise InputError
    void set_speed(double factor);  // > 0, otherwise InputError
    // Waits where the flow after a tear is due and not yet computed. Throws Cancelled soon after a
    // stop is requested meanwhile; restore() must then be called before another step.
    void step(double dt_s, const std::stop_token& stop = {});

    FlowCheckpoint checkpoint() const;
    // Continues as the part that the checkpoint was taken from, on the same case; an injection that
    // was being computed is started again. Throws InputError and changes nothing where the
    // checkpoint is not of this tree.
    void restore(const FlowCheckpoint& checkpoint);
    // Hash of everything in a checkpoint except `arrival` and `options`, which follow from the
    // rest, and `injections` and `reached_before`, which change no step.
    std::uint64_t state_hash() const;

    const DrugView& drug() const { return drug_; }
    // When the drug reaches a stump that a vertex lies at, -1 for none: as computed for the stump
    // where it is known, otherwise as the vertex. Infinity: never, or not known.
    float arrival_at_stump_s(const ThroughTear& tear, int vertex) const;
    // The place on the tree that a vertex belongs to.
    const TreePoint& place_of(int vertex) const { return (*places_)[vertex]; }
    double speed() const { return drug_.speed; }
    // Largest imbalance of a node in the last injection's flow, relative to the injected flow.
    double mass_error_relative() const { return mass_error_relative_; }

  private:
    void start(const Injection& injection, DrugArrival arrival);
    void show(const Injection& injection, DrugArrival arrival);
    std::vector<float> without_cut_off(std::vector<float> arrival_s, const Injection& injection,
                                       std::size_t known) const;
    void keep_reached();
    void show_what_is_due(const std::stop_token& stop);
    void end_run();
    void drop_ended_runs();
    void follow_topology();
    void require_place(const std::optional<Injection>& injection) const;
    void require_segment(int segment) const;

    VesselTree tree_;
    const BodyTopology& topology_;
    std::uint64_t followed_;  // version of the topology that places_ are of
    // Replaced but never changed, because a run may be reading it.
    std::shared_ptr<const std::vector<TreePoint>> places_;
    double mass_error_relative_ = 0.0;
    DrugView drug_;
    std::optional<Injection> injected_;               // what drug_ shows
    std::vector<float> at_tears_s_;                   // per last tear of injected_
    std::unique_ptr<InjectionRun> run_;               // what will replace it
    bool updating_ = false;                           // run_ is injected_ with more tears
    int steps_left_ = 0;                              // as in FlowCheckpoint
    std::list<std::unique_ptr<InjectionRun>> ended_;  // cancelled, not yet finished
};

}  // namespace hepatica
