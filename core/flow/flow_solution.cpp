// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/flow_solution.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "core/base/error.h"

namespace hepatica {

namespace {

// A shorter segment counts as this share of its radius; two nodes in one place would otherwise be
// joined by an infinite conductance.
constexpr double shortest_length_per_radius = 1e-9;

Cone not_shorter(Cone cone) {
    cone.length_mm =
        std::max(cone.length_mm, shortest_length_per_radius *
                                     std::min(cone.proximal_radius_mm, cone.distal_radius_mm));
    return cone;
}

[[noreturn]] void reject(const char* what, double value, const std::string& remedy) {
    std::ostringstream problem;
    problem << what << " is " << value;
    throw InputError(problem.str(), "flow conditions", remedy);
}

void check_pressure(const char* what, double value) {
    if (!(std::abs(value) <= 1e12)) reject(what, value, "Give a pressure in Pa, at most 1e12");
}

void validate_conditions(const FlowNetwork& network, const FlowConditions& conditions) {
    validate(conditions.resident);
    check_pressure("the outlet pressure", conditions.outlet_pressure_pa);
    check_pressure("the ambient pressure", conditions.ambient_pressure_pa);
    for (const double pressure : conditions.outlet_pressures_pa)
        check_pressure("an outlet pressure", pressure);
    const std::size_t outlets = network.outlet_nodes.size();
    if (!conditions.outlet_pressures_pa.empty() && conditions.outlet_pressures_pa.size() != outlets)
        reject("the number of outlet pressures",
               static_cast<double>(conditions.outlet_pressures_pa.size()),
               "Give one per outlet: " + std::to_string(outlets));
    if (!conditions.terminal_resistances.empty() &&
        conditions.terminal_resistances.size() != outlets)
        reject("the number of terminal resistances",
               static_cast<double>(conditions.terminal_resistances.size()),
               "Give one per outlet: " + std::to_string(outlets));
    for (const double resistance : conditions.terminal_resistances)
        if (!(resistance >= 0.0) || (resistance > 1e30 && !std::isinf(resistance)))
            reject("a terminal resistance", resistance,
                   "Give a value in Pa s/mm3, 0 or more; infinity closes the outlet");
    if (!(conditions.bifurcation_loss_coefficient >= 0.0 &&
          conditions.bifurcation_loss_coefficient <= 1e3))
        reject("the bifurcation loss coefficient", conditions.bifurcation_loss_coefficient,
               "Give a value from 0 to 1000; about 1 is the engineering upper end");
    if (!conditions.torn_areas_mm2.empty() &&
        conditions.torn_areas_mm2.size() != network.torn_nodes.size())
        reject("the openings of torn vessels",
               static_cast<double>(conditions.torn_areas_mm2.size()), "Give one for each or none");
    for (const double area : conditions.torn_areas_mm2)
        if (!(area > 0.0) || !std::isfinite(area))
            reject("the opening of a torn vessel [mm2]", area, "Give more than 0");
    for (const Inlet& inlet : conditions.inlets) {
        if (inlet.node < 0 || inlet.node >= network.node_count)
            reject("an inlet's node", inlet.node, "Name a node of the network");
        validate(inlet.fluid);
        if (inlet.kind == InletKind::mass_flow) {
            validate_mass_flow(inlet.value);
            continue;
        }
        check_pressure("an inlet pressure", inlet.value);
        if (conditions.torn_areas_mm2.empty() &&
            std::ranges::find(network.torn_nodes, inlet.node) != network.torn_nodes.end())
            throw InputError("a pressure drives the flow where a vessel is torn and open",
                             "flow conditions", "Give a mass flow there, or inject elsewhere");
    }
}

// Tears open straight into the surroundings, or through orifices.
void add_tears(const FlowNetwork& network, const FlowConditions& conditions,
               HydraulicCircuit& circuit, std::vector<int>& opening_element) {
    opening_element.clear();
    for (std::size_t i = 0; i < network.torn_nodes.size(); ++i) {
        const int node = network.torn_nodes[i];
        if (conditions.torn_areas_mm2.empty()) {
            circuit.fixed_pressure_pa[node] = conditions.ambient_pressure_pa;
            continue;
        }
        const double throat = discharge_coefficient * conditions.torn_areas_mm2[i];
        HydraulicElement opening;
        opening.from = node;
        opening.to = circuit.node_count++;
        opening.quadratic = 0.5 * conditions.resident.density_g_mm3 / (throat * throat);
        opening.linear = 1e-6 * opening.quadratic;  // the slope at 1e-6 mm3/s, so that none is 0
        circuit.source_mm3_s.push_back(0.0);
        circuit.fixed_pressure_pa.push_back(conditions.ambient_pressure_pa);
        opening_element.push_back(static_cast<int>(circuit.elements.size()));
        circuit.elements.push_back(opening);
    }
}

// Lost head as a share of the dynamic pressure at the proximal end: bifurcation loss and jet loss.
double head_lost(const FlowSegment& segment, const std::vector<int>& degree,
                 const FlowConditions& conditions) {
    const bool branches = degree[segment.proximal_node] > 2;
    return (branches ? conditions.bifurcation_loss_coefficient : 0.0) + segment.jet_loss;
}

HydraulicCircuit circuit_of(const FlowNetwork& network, const FlowConditions& conditions,
                            const std::vector<int>& degree, std::vector<int>& terminal_element,
                            std::vector<int>& opening_element) {
    validate_conditions(network, conditions);
    const std::size_t outlets = network.outlet_nodes.size();
    const bool resistive = !conditions.terminal_resistances.empty();
    HydraulicCircuit circuit(network.node_count + (resistive ? static_cast<int>(outlets) : 0));
    circuit.elements.reserve(network.segments.size() + (resistive ? outlets : 0));
    circuit.parts.reserve(network.cones.size());
    for (const FlowSegment& segment : network.segments) {
        HydraulicElement element;
        element.from = segment.proximal_node;
        element.to = segment.distal_node;
        element.open = segment.open;
        element.first_part = static_cast<int>(circuit.parts.size());
        element.part_count = segment.cone_count;
        for (int c = segment.first_cone; c < segment.first_cone + segment.cone_count; ++c)
            circuit.parts.push_back({not_shorter(network.cones[c]), conditions.resident});
        summarise(element, circuit.parts, conditions.law, head_lost(segment, degree, conditions));
        circuit.elements.push_back(element);
    }
    terminal_element.assign(outlets, -1);
    for (std::size_t o = 0; o < outlets; ++o) {
        const double pressure = conditions.outlet_pressures_pa.empty()
                                    ? conditions.outlet_pressure_pa
                                    : conditions.outlet_pressures_pa[o];
        const double resistance = resistive ? conditions.terminal_resistances[o] : 0.0;
        if (resistance == 0.0) {
            circuit.fixed_pressure_pa[network.outlet_nodes[o]] = pressure;
            continue;
        }
        HydraulicElement bed;
        bed.from = network.outlet_nodes[o];
        bed.to = network.node_count + static_cast<int>(o);
        bed.linear = std::isinf(resistance) ? 0.0 : resistance;
        bed.open = !std::isinf(resistance);
        circuit.fixed_pressure_pa[bed.to] = pressure;
        terminal_element[o] = static_cast<int>(circuit.elements.size());
        circuit.elements.push_back(bed);
    }
    add_tears(network, conditions, circuit, opening_element);
    for (const Inlet& inlet : conditions.inlets)
        if (inlet.kind == InletKind::pressure) circuit.fixed_pressure_pa[inlet.node] = inlet.value;
    return circuit;
}

std::vector<int> degrees_of(const FlowNetwork& network) {
    std::vector<int> degree(network.node_count, 0);
    for (const FlowSegment& segment : network.segments) {
        ++degree[segment.proximal_node];
        ++degree[segment.distal_node];
    }
    return degree;
}

}  // namespace

NetworkFlow::NetworkFlow(const FlowNetwork& network, const FlowConditions& conditions)
    : network_(network),
      conditions_(conditions),
      degree_(degrees_of(network)),
      inflow_density_g_mm3_(network.segments.size(), conditions.resident.density_g_mm3),
      outflow_density_g_mm3_(network.segments.size(), conditions.resident.density_g_mm3),
      circuit_(circuit_of(network, conditions, degree_, terminal_element_, opening_element_)),
      solver_(circuit_) {
    part_capacity_.reserve(network.segments.size());
    for (const FlowSegment& segment : network.segments)
        part_capacity_.push_back(segment.cone_count);
    for (std::size_t i = 0; i < conditions_.inlets.size(); ++i) set_source(static_cast<int>(i));
}

void NetworkFlow::set_source(int inlet) {
    // Several inlets may share a node.
    const int node = conditions_.inlets[inlet].node;
    double volume = 0.0;
    for (const Inlet& other : conditions_.inlets)
        if (other.node == node && other.kind == InletKind::mass_flow)
            volume += other.value / other.fluid.density_g_mm3;
    circuit_.source_mm3_s[node] = volume;
}

void NetworkFlow::drive(int inlet, double value) {
    Inlet& changed = conditions_.inlets[inlet];
    changed.value = value;
    if (changed.kind == InletKind::pressure) {
        check_pressure("an inlet pressure", value);
        circuit_.fixed_pressure_pa[changed.node] = value;
    } else {
        validate_mass_flow(value);
        set_source(inlet);
    }
}

void NetworkFlow::fill(int segment, const std::vector<Filling>& fillings) {
    HydraulicElement& element = circuit_.elements[segment];
    const FlowSegment& s = network_.segments[segment];
    const int needed = s.cone_count + static_cast<int>(fillings.size()) - 1;
    if (needed > part_capacity_[segment]) {
        element.first_part = static_cast<int>(circuit_.parts.size());
        part_capacity_[segment] = needed + 1;
        circuit_.parts.resize(circuit_.parts.size() + needed + 1);
    }
    // Walks along the cones and cuts them where one filling ends.
    element.part_count = 0;
    const auto add = [&](const Cone& cone, const Fluid& fluid) {
        circuit_.parts[element.first_part + element.part_count++] = {cone, fluid};
    };
    std::size_t filling = 0;
    double end_of_filling = arclength_at_mm(network_, segment, fillings[0].volume_mm3);
    double filled = fillings[0].volume_mm3;
    double begin = 0.0;
    for (int c = s.first_cone; c < s.first_cone + s.cone_count; ++c) {
        const Cone cone = not_shorter(network_.cones[c]);
        const double taper = (cone.distal_radius_mm - cone.proximal_radius_mm) / cone.length_mm;
        const auto radius = [&](double x) { return cone.proximal_radius_mm + taper * x; };
        double from = 0.0;
        while (filling + 1 < fillings.size() && end_of_filling < begin + cone.length_mm) {
            const double to = std::max(from, end_of_filling - begin);
            add({radius(from), radius(to), to - from}, fillings[filling].fluid);
            from = to;
            filled += fillings[++filling].volume_mm3;
            end_of_filling = arclength_at_mm(network_, segment, filled);
        }
        add({radius(from), cone.distal_radius_mm, std::max(cone.length_mm - from, 0.0)},
            fillings[filling].fluid);
        begin += network_.cones[c].length_mm;
    }
    summarise(element, circuit_.parts, conditions_.law, head_lost(s, degree_, conditions_));
    inflow_density_g_mm3_[segment] = fillings.front().fluid.density_g_mm3;
    outflow_density_g_mm3_[segment] = fillings.back().fluid.density_g_mm3;
}

const FlowSolution& NetworkFlow::solve() {
    const HydraulicState state =
        solver_.solve(circuit_, conditions_.outlet_pressure_pa, guess_.empty() ? nullptr : &guess_);
    read_back(state);
    guess_ = state.flow_mm3_s;
    return solution_;
}

// What leaves the network at a node through a bed and an opening.
double NetworkFlow::leaving_at(int node, const HydraulicState& state) const {
    double leaving = 0.0;
    for (std::size_t o = 0; o < network_.outlet_nodes.size(); ++o)
        if (network_.outlet_nodes[o] == node && terminal_element_[o] >= 0)
            leaving += state.flow_mm3_s[terminal_element_[o]];
    for (std::size_t t = 0; t < opening_element_.size(); ++t)
        if (network_.torn_nodes[t] == node) leaving += state.flow_mm3_s[opening_element_[t]];
    return leaving;
}

void NetworkFlow::read_back(const HydraulicState& state) {
    const std::size_t segments = network_.segments.size();
    solution_.newton_steps = state.newton_steps;
    solution_.volume_flow_mm3_s.assign(state.flow_mm3_s.begin(),
                                       state.flow_mm3_s.begin() + static_cast<long>(segments));
    solution_.mass_flow_g_s.resize(segments);
    std::vector<double> surplus(network_.node_count, 0.0);  // inflow minus outflow of each node
    for (std::size_t i = 0; i < segments; ++i) {
        const double q = state.flow_mm3_s[i];
        solution_.mass_flow_g_s[i] =
            q * (q >= 0.0 ? inflow_density_g_mm3_[i] : outflow_density_g_mm3_[i]);
        surplus[network_.segments[i].proximal_node] -= q;
        surplus[network_.segments[i].distal_node] += q;
    }
    solution_.total_pressure_pa.assign(state.pressure_pa.begin(),
                                       state.pressure_pa.begin() + network_.node_count);
    double total_inflow = 0.0;
    solution_.inlet_flow_mm3_s.clear();
    solution_.inlet_pressure_pa.clear();
    for (const Inlet& inlet : conditions_.inlets) {
        double q = 0.0;
        if (inlet.kind == InletKind::mass_flow) {
            q = inlet.value / inlet.fluid.density_g_mm3;
            surplus[inlet.node] += q;
        } else {
            const double leaving = leaving_at(inlet.node, state);
            q = leaving - surplus[inlet.node];  // without the sign of -0
            surplus[inlet.node] = leaving;
        }
        total_inflow += std::abs(q);
        solution_.inlet_flow_mm3_s.push_back(q);
        solution_.inlet_pressure_pa.push_back(state.pressure_pa[inlet.node]);
    }
    const auto leave = [&](int node) {
        const double q = surplus[node];
        surplus[node] = 0.0;
        return q;
    };
    solution_.outlet_flow_mm3_s.clear();
    for (std::size_t o = 0; o < network_.outlet_nodes.size(); ++o) {
        const int node = network_.outlet_nodes[o];
        const int bed = terminal_element_[o];
        if (bed < 0) {
            solution_.outlet_flow_mm3_s.push_back(leave(node));
        } else {
            const double q = state.flow_mm3_s[bed];  // 0 where it is closed
            surplus[node] -= q;
            solution_.outlet_flow_mm3_s.push_back(q);
        }
    }
    solution_.torn_flow_mm3_s.clear();
    for (const int node : network_.torn_nodes) solution_.torn_flow_mm3_s.push_back(leave(node));
    double worst = 0.0;
    for (const double s : surplus) worst = std::max(worst, std::abs(s));
    for (const double q : solution_.outlet_flow_mm3_s) total_inflow += std::max(0.0, -q);
    solution_.mass_error_relative = total_inflow > 0.0 ? worst / total_inflow : worst;
}

FlowSolution solve_flow(const FlowNetwork& network, const FlowConditions& conditions) {
    return NetworkFlow(network, conditions).solve();
}

SegmentPressures static_pressures(const FlowNetwork& network, const FlowSolution& solution,
                                  const Fluid& fluid, int segment) {
    const FlowSegment& s = network.segments[segment];
    const double flow = solution.mass_flow_g_s[segment];
    return {solution.total_pressure_pa[s.proximal_node] -
                dynamic_pressure_pa(proximal_radius_mm(network, segment), fluid, flow),
            solution.total_pressure_pa[s.distal_node] -
                dynamic_pressure_pa(distal_radius_mm(network, segment), fluid, flow)};
}

std::vector<double> murray_terminal_resistances(const FlowNetwork& network, double total_pa_s_mm3,
                                                double exponent) {
    if (!(total_pa_s_mm3 > 0.0 && total_pa_s_mm3 <= 1e12))
        reject("the total terminal resistance", total_pa_s_mm3,
               "Give a positive value in Pa s/mm3");
    std::vector<double> radius(network.node_count, 0.0);
    for (std::size_t i = 0; i < network.segments.size(); ++i) {
        const FlowSegment& s = network.segments[i];
        const int id = static_cast<int>(i);
        radius[s.proximal_node] =
            std::max(radius[s.proximal_node], proximal_radius_mm(network, id));
        radius[s.distal_node] = std::max(radius[s.distal_node], distal_radius_mm(network, id));
    }
    std::vector<double> resistances;
    double sum = 0.0;
    for (const int node : network.outlet_nodes) {
        const double conductance = std::pow(radius[node], exponent);
        sum += conductance;
        resistances.push_back(conductance);
    }
    for (double& r : resistances) r = total_pa_s_mm3 * sum / r;
    return resistances;
}

}  // namespace hepatica
