// SPDX-License-Identifier: GPL-3.0-or-later
// One injection from start to end: where the catheter is, what is injected and how, and the
// resulting arrival times, flows and series over time. The paper's section II.B in one call.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/job.h"
#include "core/flow/drug_front.h"
#include "core/flow/territory.h"

namespace hepatica {

// The longest run without a given end, in multiples of the time to inject the volume of the tree.
// In loops and between ends of equal pressure the blood hardly moves, and filling would never end.
inline constexpr double longest_run_in_fillings = 10.0;

// The longest run that may be asked for.
inline constexpr double longest_run_s = 1e9;

// Throws InputError where nothing can be injected at this mass flow.
void validate_drug_flow(double mass_flow_g_s);

// What is torn from a time on, in place of all that was before; as in InjectionOptions.
struct LaterTears {
    double from_s = 0.0;
    std::vector<TreePoint> tears{};
    std::vector<double> areas_mm2{};
    std::vector<std::uint8_t> sides{};
};

struct InjectionOptions {
    // The catheter's tip; none: the root of the system with the largest volume (see main_root).
    std::optional<TreePoint> tip;
    // A wedged tip fills the lumen: only vessels downstream of it are perfused. Blood that enters
    // at the root (blood_flow_g_s) passes a free tip and carries the drug along, or is pushed back
    // by it.
    bool wedged = true;
    double blood_flow_g_s = 0.0;

    double mass_flow_g_s = 2.0;  // of the injected fluid; above 0
    // Total pressure at the tip instead of the mass flow; above outlet_pressure_pa.
    std::optional<double> inlet_pressure_pa;
    PressureLaw law = PressureLaw::regime;
    // The fluid in the vessels before the injection.
    Phase liquid = blood();
    // The injected fluid: that liquid with this volume fraction of a second phase; 0: the liquid
    // alone.
    Phase second_phase = lipiodol();
    double void_fraction = 0.0;
    std::optional<double> drug_viscosity_pa_s;  // instead of (9)

    SegmentShape shape = SegmentShape::one_cone;
    double outlet_pressure_pa = 0.0;
    // Resistance of the vessels too small to see, all in parallel, distributed by Murray's law; 0:
    // none.
    double terminal_resistance_pa_s_mm3 = 0.0;
    double bifurcation_loss_coefficient = 0.0;

    std::vector<int> closed_segments;  // of the tree: clamped, plugged
    std::vector<TreePoint> tears;      // both stumps bleed

    double injection_s = std::numeric_limits<double>::infinity();  // then the catheter is closed
    // When the run ends; none: when nothing changes any more, and at most after
    // longest_run_in_fillings.
    std::optional<double> until_s;
    // Time between the samples of the series, which does not affect the solution; none: a hundredth
    // of the time to inject the volume of the tree.
    std::optional<double> step_s;
    FrontOptions front;  // its injection_end_s is ignored
    // Whose drug is to be followed, each as the flow at the start has it: what a later flow carries
    // into other vessels, as behind a tear that closes again, counts in none.
    std::vector<TreePoint> territories;
    bool record_filled_lengths = false;  // per segment and sample
    // Of each of `tears`, the opening at both stumps, above 0; empty: nothing holds the flow up
    // there. As many as tears, or none.
    std::vector<double> tear_areas_mm2;
    // Of each of `tears`, whether only the side is open and the vessel goes on (not 0); empty: none
    // is. As many as tears, which then have areas, or none.
    std::vector<std::uint8_t> tear_sides;
    // What changes of `tears` during the run, ascending in time. The flow is solved anew at each
    // change, and the front goes on from where it is.
    std::vector<LaterTears> later_tears;
};

// The state at one moment.
struct InjectionSample {
    double time_s = 0.0;
    double inlet_pressure_pa = 0.0;  // total, at the tip
    double inlet_flow_g_s = 0.0;
    double injected_g = 0.0;
    double inside_g = 0.0;
    double delivered_g = 0.0;              // through outlets, into the vessels too small to see
    double filled_fraction = 0.0;          // of the volume of the whole tree
    std::vector<double> outlet_mass_g;     // per InjectionResult::outlet_nodes
    std::vector<double> territory_mass_g;  // inside the territory's vessels and through its outlets
    std::vector<float> filled_length_mm;   // per segment of the vessel tree; empty if not recorded
    double bled_g = 0.0;                   // out of torn vessels
};

struct InjectionResult {
    // At the start, with the catheter in place. Later tears join the same segments otherwise.
    FlowNetwork network;
    FlowConditions conditions;
    int tip_node = -1;
    Fluid drug;
    FlowSolution begin;  // all vessels filled with blood
    FlowSolution end;    // as filled at the end
    ArrivalTimes arrival;
    std::vector<Territory> territories;
    std::vector<InjectionSample> series;  // the first at time 0
    DrugBalance balance;
    std::uint64_t steps = 0;
    // Outlets of the vessels without tears, ascending: one that is torn off may be closed later.
    std::vector<int> outlet_nodes;
};

// With two different fluids the splits at branchings change while the vessels fill. The arrival
// times are those of the stepped front, and equal the closed form where the drug has the blood's
// properties. `sampled` is called after each sample of the series with what there is by then: the
// network, the start and the series. Begins one stage of the job. Throws InputError where an option
// is out of range or nothing can flow, and Cancelled.
InjectionResult inject(const VesselTree& tree, const InjectionOptions& options, Job& job,
                       const std::function<void(const InjectionResult&)>& sampled = {});

// The options as they are from `later` on until the next change.
InjectionOptions torn_later(const InjectionOptions& options, const LaterTears& later);

// Tears the network at the options' tears and sets the openings in the conditions. Throws
// InputError where there is no such segment.
void tear_for(const InjectionOptions& options, FlowNetwork& network, FlowConditions& conditions);

// The injected fluid of these options.
Fluid drug_of(const InjectionOptions& options);

// The default place of injection: the root of an artery if there is one, else of the portal vein,
// of vessels of an unknown system, of hepatic veins, in this order; of several trees the one with
// the largest volume. Throws InputError if the tree is empty.
TreePoint main_root(const VesselTree& tree);

// Mass flow of a tree segment at the end, g/s from proximal to distal; where the catheter or a tear
// divides the segment, that of the part with the largest flow.
double end_flow_g_s(const InjectionResult& injection, int tree_segment);
// When any part of a tree segment is first reached; infinity: never.
double first_arrival_s(const InjectionResult& injection, int tree_segment);

}  // namespace hepatica
