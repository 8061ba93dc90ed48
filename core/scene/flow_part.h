// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a world through which a drug runs: the network, the injection, its clock, and the
// time at which the front reaches each vertex.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/flow/injection.h"
#include "core/scene/default_injection.h"
#include "core/scene/frame.h"
#include "core/scene/scene_spec.h"
#include "core/scene/vertex_places.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

struct Injection {
    TreePoint at;                                                    // on the tree at rest
    double mass_flow_g_s = default_injection::mass_flow_g_s;         // > 0
    double void_fraction = default_injection::void_fraction;         // of the second phase, [0, 1)
    std::string second_phase = default_injection::second_phase;      // gas, lipiodol or carrier
    std::string pressure_model = default_injection::pressure_model;  // published, consistent or
                                                                     // regime
    double drug_viscosity_pa_s = 0.0;  // > 0; 0: what the mixture gives
};

// The same as core/flow/injection.h takes it: through a free tip, at the place where a system is
// supplied if the injection is within a radius of it.
InjectionOptions injection_options(const Injection& injection, const VesselTree& tree);

class FlowPart {
  public:
    // `places` are those of the vertices shown. Throws InputError for an empty tree.
    FlowPart(const VesselTree& tree, const std::vector<VertexPlace>& places, const FlowSpec& spec);

    // The vessels are full of blood, at rest but for the injection, and every outlet is at the same
    // pressure. Solves the flow and starts the drug's clock. A drug unlike blood changes the splits
    // as it advances: its times are those of the stepped front, else of the closed form. Throws
    // InputError for values out of range; what was injected before then stays.
    void inject(const Injection& injection);
    void remove_drug();
    void play(bool playing) { drug_.playing = playing && drug_.arrival_s != nullptr; }
    void set_time(double time_s);   // >= 0, else InputError
    void set_speed(double factor);  // > 0, else InputError
    void step(double dt_s);

    const DrugView& drug() const { return drug_; }
    // The place on the tree that a vertex belongs to.
    const TreePoint& place_of(int vertex) const { return places_[vertex]; }
    double speed() const { return speed_; }
    // Largest imbalance of a node in the flow last injected, over what is injected.
    double mass_error_relative() const { return mass_error_relative_; }

  private:
    VesselTree tree_;
    std::vector<TreePoint> places_;
    double speed_;
    double mass_error_relative_ = 0.0;
    DrugView drug_;
};

}  // namespace hepatica
