// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a world through which a drug runs: the injection, its clock, and the time at which
// the front reaches each vertex.
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

// All that determines the part's steps to come, apart from the case and the scene's spec.
struct FlowCheckpoint {
    std::optional<Injection> injected;
    std::optional<Injection> computing;
    double time_s = 0.0;
    bool playing = false;
    double speed = 1.0;
    // What came of `injected`, so that going back costs nothing; computed anew where it is empty,
    // as it is in a file.
    DrugArrival arrival{};
};

class FlowPart {
  public:
    // `places` are those of the vertices of `topology`, which must outlive the part; what is kept
    // per vertex follows it. Throws InputError for an empty tree.
    FlowPart(const VesselTree& tree, const std::vector<VertexPlace>& places, const FlowSpec& spec,
             const BodyTopology& topology);
    ~FlowPart();  // cancels what is being computed

    // The vessels are full of blood, at rest but for the injection, and every outlet is at the same
    // pressure. A drug that flows like blood is there at once, in O(segments + vertices); another
    // is computed on a thread of its own, and what was injected before stays until
    // finish_injection(). Ends what was being computed. Throws InputError for values out of range;
    // everything then stays as it was.
    void inject(const Injection& injection);
    // An injection is being computed; and it is done, so that finish_injection() need not wait.
    bool computing() const { return run_ != nullptr; }
    bool injection_ready() const { return run_ != nullptr && run_->ready(); }
    // Puts the injection that is being computed in the place of the last one and starts the drug's
    // clock; waits for it where it is not done. Does nothing where none is being computed. Throws
    // what computing it threw (InputError where nothing can flow; Cancelled soon after a stop was
    // asked for); the last one then stays.
    void finish_injection(const std::stop_token& stop = {});
    // Takes the drug away and ends what is being computed.
    void remove_drug();
    // The clock runs until the drug's end_s and stops there.
    void play(bool playing) { drug_.playing = playing && drug_.arrival_s != nullptr; }
    void set_time(double time_s);   // >= 0, else InputError
    void set_speed(double factor);  // > 0, else InputError
    void step(double dt_s);

    FlowCheckpoint checkpoint() const;
    // Goes on as the part that the checkpoint was taken from, on the same case; what was being
    // computed is begun anew. Throws InputError where the checkpoint is not of this tree, and
    // changes nothing then.
    void restore(const FlowCheckpoint& checkpoint);
    // Of all that a checkpoint holds but `arrival`, which follows from it.
    std::uint64_t state_hash() const;

    const DrugView& drug() const { return drug_; }
    // The place on the tree that a vertex belongs to.
    const TreePoint& place_of(int vertex) const { return (*places_)[vertex]; }
    double speed() const { return drug_.speed; }
    // Largest imbalance of a node in the flow last injected, over what is injected.
    double mass_error_relative() const { return mass_error_relative_; }

  private:
    void start(const Injection& injection, DrugArrival arrival);
    void end_run();
    void drop_ended_runs();
    void follow_topology();
    void require_place(const std::optional<Injection>& injection) const;

    VesselTree tree_;
    const BodyTopology& topology_;
    // Replaced and never changed, because a run may be reading it.
    std::shared_ptr<const std::vector<TreePoint>> places_;
    double mass_error_relative_ = 0.0;
    DrugView drug_;
    std::optional<Injection> injected_;               // what drug_ shows
    std::unique_ptr<InjectionRun> run_;               // what is to take its place
    std::list<std::unique_ptr<InjectionRun>> ended_;  // cancelled, on their way out
};

}  // namespace hepatica
