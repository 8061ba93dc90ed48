// SPDX-License-Identifier: GPL-3.0-or-later
// Transport of the drug: an injected fluid displaces the fluid in the vessels, without mixing along
// a vessel and with full mixing where flows meet. This is the paper's "partial length of each
// segment that is filled at each time step"; a step ends exactly when a front reaches a node.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "core/flow/arrival_times.h"
#include "core/flow/flow_solution.h"

namespace hepatica {

struct FrontOptions {
    // End of the injection: the drug's inlet closes, other inlets stay open and wash the drug out.
    double injection_end_s = std::numeric_limits<double>::infinity();
    // Two different fluids only: the largest change of any segment's flow within one step, as a
    // share of the total inflow. Smaller is more accurate and slower; the error falls with its
    // square.
    double step_tolerance = 1e-2;
    // Loops only: neighbouring slugs whose drug shares differ by less are merged; mass is
    // conserved.
    double concentration_tolerance = 1e-4;
};

enum class FrontEvent { none, node_reached, injection_ended };

struct FrontStep {
    double duration_s = 0.0;
    FrontEvent event = FrontEvent::none;
};

// Where all of the drug is, in mm3 of injected fluid. injected = inside + left through outlets +
// bled from torn vessels, up to rounding.
struct DrugBalance {
    double injected_mm3 = 0.0;
    double inside_mm3 = 0.0;
    double left_mm3 = 0.0;
    double bled_mm3 = 0.0;
    double error_relative() const {
        const double lost = injected_mm3 - inside_mm3 - left_mm3 - bled_mm3;
        return injected_mm3 > 0.0 ? (lost < 0.0 ? -lost : lost) / injected_mm3 : 0.0;
    }
};

// Fluids are incompressible, so flows here are volumes; the pressure drop follows the fluid that
// fills each place (equations 2 and 9 by share). If drug and blood have the same properties, flows
// never change and the step size does not matter; otherwise the flow is solved twice per step
// (Heun's rule).
class DrugFront {
  public:
    // The drug enters at conditions.inlets[drug_inlet] with that inlet's fluid; through all other
    // inlets and outlets conditions.resident enters. `outlets` are the nodes of all outlets that
    // this or a later network has, see rejoin(); empty: those of this one. Throws what solve_flow
    // throws.
    DrugFront(FlowNetwork network, FlowConditions conditions, int drug_inlet,
              const FrontOptions& options = {}, std::vector<int> outlets = {});
    DrugFront(const DrugFront&) = delete;
    DrugFront& operator=(const DrugFront&) = delete;

    // One step of at most `longest_s`; an event or the tolerance may shorten it.
    FrontStep step(double longest_s);
    // One step towards a time, which the last such step meets exactly.
    FrontStep step_towards(double time_s);
    void advance_to(double time_s);
    // From now on the same segments join other nodes, as where a vessel is torn, with other outlets
    // and openings; what fills them stays. The conditions have the inlets that are still open, in
    // their order. Throws what solve_flow throws; the front is then of no more use.
    void rejoin(FlowNetwork network, FlowConditions conditions);
    // Whether the drug's inlet is still open.
    bool injecting() const { return drug_inlet_ >= 0; }
    // No boundary between drug and blood will move any more under the present conditions.
    bool at_rest() const { return at_rest_; }

    double time_s() const { return time_s_; }
    const FlowNetwork& network() const { return network_; }
    const FlowSolution& flow() const { return flow_->solution(); }
    const Fluid& drug() const { return drug_; }

    // Share of a segment's volume that is drug, and the length over which the drug has advanced.
    double filled_fraction(int segment) const;
    double filled_length_mm(int segment) const;
    double drug_mm3(int segment) const;
    // The drug in the first `volume_mm3` of the segment from its proximal node.
    double drug_up_to_mm3(int segment, double volume_mm3) const;
    DrugBalance balance() const;
    // Drug that has left through each outlet, in g, in the constructor's order.
    const std::vector<double>& outlet_mass_g() const { return outlet_mass_g_; }
    std::uint64_t steps() const { return steps_; }

    // When the drug reached each place that it has reached so far.
    ArrivalTimes arrival_times() const;

  private:
    struct Slug {
        double volume_mm3;
        double share;  // of drug
    };
    using Slugs = std::vector<Slug>;  // from proximal to distal
    struct Flows {
        std::vector<double> segment_mm3_s;
        std::vector<double> inlet_mm3_s;
    };
    struct Saved {
        int segment;
        Slugs slugs;
    };

    bool two_fluids() const { return !(drug_ == conditions_.resident); }
    double share_at(int segment, bool distal_end) const;
    double time_to_event(const std::vector<double>& flow, double tolerance) const;
    void look_ahead();
    void mix_at_nodes(const Flows& flows);
    void move(const Flows& flows, double duration_s, std::vector<Saved>* saved);
    void push(int segment, double volume_mm3, bool from_proximal, double share);
    void count(const Flows& flows, double duration_s);
    // Up to where, from the proximal node, the drug that comes with the flow has filled a segment.
    std::optional<double> leading_edge_mm3(int segment, bool forwards, double limit) const;
    void note_arrivals(const Flows& flows, double begin_s);
    void refill(const std::vector<int>& segments);
    Flows predict(double& duration_s);
    void end_injection();
    void begin_flow();

    FlowNetwork network_;
    FlowConditions conditions_;
    FrontOptions options_;
    int drug_inlet_;
    Fluid drug_;
    std::vector<double> volume_mm3_;
    std::unique_ptr<NetworkFlow> flow_;
    std::vector<Slugs> slugs_;          // empty: blood only
    std::vector<int> touched_;          // segments whose filling the last move changed, ascending
    std::vector<double> node_share_;    // of drug in what leaves each node
    std::vector<double> node_surplus_;  // mm3/s that leave the network at each node
    double negligible_mm3_s_ = 0.0;
    bool at_rest_ = false;
    double suggested_s_ = std::numeric_limits<double>::infinity();
    std::vector<int> outlets_;  // nodes, of all networks
    std::vector<double> outlet_mass_g_;
    double injected_mm3_ = 0.0;
    double left_mm3_ = 0.0;
    double bled_mm3_ = 0.0;
    double time_s_ = 0.0;
    std::uint64_t steps_ = 0;
    std::vector<std::vector<ArrivalTimes::Knot>> reached_from_proximal_;
    std::vector<std::vector<ArrivalTimes::Knot>> reached_from_distal_;
};

}  // namespace hepatica
