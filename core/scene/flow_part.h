// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a world through which a drug runs: the network, the injection, its clock, and the
// time at which the front reaches each vertex.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/anatomy/vessel_tree.h"
#include "core/scene/frame.h"
#include "core/scene/scene_spec.h"
#include "core/scene/vertex_places.h"

namespace hepatica {

struct Injection {
    TreePoint at;                           // on the tree at rest
    double mass_flow_g_s = 2.0;             // > 0
    double void_fraction = 0.0;             // share of the second phase, in [0, 1)
    std::string second_phase = "carrier";   // gas, lipiodol or carrier
    std::string pressure_model = "regime";  // published, consistent or regime
    double drug_viscosity_pa_s = 0.0;       // > 0; 0: what the mixture gives
};

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
