// SPDX-License-Identifier: GPL-3.0-or-later
// Steady, incompressible flow through a vessel network: boundary conditions and solution. Trees are
// solved in O(segments), loops by Newton on the node pressures. All pressures are total pressures p
// + G^2/(2 rho), so that every element is monotone; static pressure is derived.
#pragma once

#include <vector>

#include "core/flow/flow_network.h"
#include "core/flow/hydraulic_circuit.h"

namespace hepatica {

enum class InletKind { mass_flow, pressure };

// Fluid driven into a node: value in g/s (of the entering fluid), or total pressure in Pa.
struct Inlet {
    int node = -1;
    InletKind kind = InletKind::mass_flow;
    double value = 0.0;
    Fluid fluid;
};

struct FlowConditions {
    PressureLaw law = PressureLaw::regime;
    Fluid resident;             // fills the vessels before anything is injected
    std::vector<Inlet> inlets;  // a root without an inlet is closed
    // Total pressure beyond every outlet; or one per outlet, in the order of outlet_nodes.
    double outlet_pressure_pa = 0.0;
    std::vector<double> outlet_pressures_pa;
    // Pa s/mm3 between each outlet and its pressure; empty: none. Infinity closes the outlet.
    std::vector<double> terminal_resistances;
    double ambient_pressure_pa = 0.0;  // around a torn vessel
    // Orifice area of each torn node, in the order of torn_nodes, with the pressure loss rho Q^2 /
    // 2 (C_d A)^2, C_d = 0.6; empty: no loss.
    std::vector<double> torn_areas_mm2;
    double bifurcation_loss_coefficient = 0.0;
};

constexpr double discharge_coefficient = 0.6;  // of a sharp-edged orifice (Idelchik)

struct FlowSolution {
    std::vector<double> volume_flow_mm3_s;  // per segment, from proximal to distal
    std::vector<double> mass_flow_g_s;      // per segment, of the fluid at its inflow end
    std::vector<double> total_pressure_pa;  // per node
    std::vector<double> outlet_flow_mm3_s;  // per outlet, positive out of the network
    std::vector<double> torn_flow_mm3_s;    // per torn node, positive out of the network
    std::vector<double> inlet_flow_mm3_s;   // per inlet, positive into the network
    std::vector<double> inlet_pressure_pa;  // per inlet, total
    double mass_error_relative = 0.0;       // largest imbalance of a node over the sum of inflows
    int newton_steps = 0;
};

// One fluid everywhere: conditions.resident. Of the inlets' fluids only the density is used, to
// convert mass flow to volume flow. Throws InputError where values are out of range, a node does
// not exist, a prescribed flow has no way out, or a prescribed pressure meets a tear without loss.
FlowSolution solve_flow(const FlowNetwork& network, const FlowConditions& conditions);

// Static pressure at a segment's ends: total minus dynamic pressure.
struct SegmentPressures {
    double proximal_static_pa = 0.0;
    double distal_static_pa = 0.0;
};
SegmentPressures static_pressures(const FlowNetwork& network, const FlowSolution& solution,
                                  const Fluid& fluid, int segment);

// Terminal resistances for flow by Murray's law: each proportional to its outlet's radius to the
// power -exponent, with `total_pa_s_mm3` for all in parallel. Exponents of 2.8 to 3.1 are measured
// in hepatic arteries (anatomy notes); Murray's is 3.
std::vector<double> murray_terminal_resistances(const FlowNetwork& network, double total_pa_s_mm3,
                                                double exponent = 3.0);

// What fills a part of a segment. Fillings go from proximal to distal and add up to its volume.
struct Filling {
    double volume_mm3 = 0.0;
    Fluid fluid;
};

// Solves the same network repeatedly while its fillings or driving values change; used by the
// stepped front. The network must outlive it and keep its shape and its open segments.
class NetworkFlow {
  public:
    NetworkFlow(const FlowNetwork& network, const FlowConditions& conditions);

    // Replaces the fillings of a segment: at least one, from proximal to distal.
    void fill(int segment, const std::vector<Filling>& fillings);
    // Replaces the driving value of an inlet, in the unit of its kind (0 g/s: nothing enters).
    void drive(int inlet, double value);

    // Starts from the last solution, so that a small change costs one or two Newton steps.
    const FlowSolution& solve();
    const FlowSolution& solution() const { return solution_; }

  private:
    void set_source(int inlet);
    double leaving_at(int node, const HydraulicState& state) const;
    void read_back(const HydraulicState& state);

    const FlowNetwork& network_;
    FlowConditions conditions_;
    std::vector<int> degree_;
    std::vector<int> part_capacity_;
    std::vector<double> inflow_density_g_mm3_;  // per segment: of its first filling
    std::vector<double> outflow_density_g_mm3_;
    std::vector<int> terminal_element_;  // per outlet: its resistance element; -1: none
    std::vector<int> opening_element_;   // per torn node: its orifice; empty: none has one
    HydraulicCircuit circuit_;
    HydraulicSolver solver_;
    std::vector<double> guess_;
    FlowSolution solution_;
};

}  // namespace hepatica
