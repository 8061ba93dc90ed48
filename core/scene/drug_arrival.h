// SPDX-License-Identifier: GPL-3.0-or-later
// The result of an injection: when the drug reaches each vertex that is shown. A drug that flows
// like the blood that it displaces has the times of the closed form, in O(segments + vertices); any
// other drug changes the splits at bifurcations as it advances and has those of the stepped front,
// which take seconds for a large tree. Where vessels tear meanwhile, both have those of the front.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/flow/injection.h"
#include "core/scene/default_injection.h"
#include "core/scene/through_tears.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// What is torn from a time of the drug's clock on, in place of what was before.
struct TornSince {
    double from_s = 0.0;
    std::vector<ThroughTear> tears{};
};

struct Injection {
    TreePoint at;                                                    // on the tree at rest
    double mass_flow_g_s = default_injection::mass_flow_g_s;         // see validate_drug_flow
    double void_fraction = default_injection::void_fraction;         // of the second phase, [0, 1)
    std::string second_phase = default_injection::second_phase;      // gas, lipiodol or carrier
    std::string pressure_model = default_injection::pressure_model;  // published, consistent or
                                                                     // regime
    double drug_viscosity_pa_s = 0.0;                                // > 0; 0: that of the mixture
    std::vector<ThroughTear> tears{};  // of the vessels as they are injected
    double least_end_s = 0.0;          // the drug's clock runs at least until then
    std::vector<TornSince> later{};    // how they tear afterwards, ascending in time

    // Those that are known last.
    const std::vector<ThroughTear>& last_tears() const {
        return later.empty() ? tears : later.back().tears;
    }
};

// The options for core/flow/injection.h: a free tip, placed where the system is supplied if the
// injection is within a radius of that; stumps bleed into the pressure of the outlets. Throws
// InputError for a value out of range.
InjectionOptions injection_options(const Injection& injection, const VesselTree& tree);

// Whether the drug has the density and viscosity of blood, so that the closed form applies.
bool flows_like_blood(const InjectionOptions& options);

struct DrugArrival {
    std::shared_ptr<const std::vector<float>> arrival_s;  // per vertex; infinity: never reached
    // > 0: when most vertices have been reached, some may be later; where a stump is reached,
    // some time after that, because drug goes on leaking. At most longest_run_s.
    double end_s = 0.0;
    // Largest imbalance of a node of the flow, relative to the injected flow.
    double mass_error_relative = 0.0;
    std::vector<float> at_tears_s{};  // per last tear of the injection: at either stump
};

// `places` are the vertices' places on the tree. The same bits on any thread. Throws InputError
// where nothing can flow or no vessel would be filled, and Cancelled.
DrugArrival drug_arrival(const VesselTree& tree, std::span<const TreePoint> places,
                         const InjectionOptions& options, Job& job);

// What is known of an injection at once when vessels tear: places that `later` cuts off from the
// catheter are not reached after it. Their times become infinite.
void cut_off(const VesselTree& tree, std::span<const TreePoint> places,
             const InjectionOptions& options, const LaterTears& later,
             std::vector<float>& arrival_s);

}  // namespace hepatica
