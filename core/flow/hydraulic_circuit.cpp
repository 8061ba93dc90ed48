// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/hydraulic_circuit.h"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "core/base/error.h"

namespace hepatica {

namespace {

constexpr int maximum_newton_steps = 100;
constexpr int maximum_line_search_steps = 40;

bool is_fixed(const HydraulicCircuit& circuit, int node) {
    return !std::isnan(circuit.fixed_pressure_pa[node]);
}

[[noreturn]] void reject_no_way_out(double source_mm3_s) {
    throw InputError(
        "a flow of " + std::to_string(source_mm3_s) + " mm3/s enters, but every way out is closed",
        "vessel network",
        "Open a segment or an outlet, or give the inlet a pressure instead of a flow");
}

}  // namespace

Drop drop_of(const HydraulicElement& element, const std::vector<HydraulicPart>& parts, double q) {
    const double size = std::abs(q);
    const double loss = element.quadratic * size;
    if (size <= element.laminar_limit_mm3_s) {
        double power = 0.0;
        if (element.power > 0.0)
            power = element.power * std::sqrt(size) * std::sqrt(std::sqrt(size));
        return {q * (element.linear + power + loss), element.linear + 1.75 * power + 2.0 * loss};
    }
    Drop drop{q * loss, 2.0 * loss};
    for (int i = element.first_part; i < element.first_part + element.part_count; ++i) {
        const double density = parts[i].fluid.density_g_mm3;
        const Drop part =
            total_pressure_drop(PressureLaw::regime, parts[i].cone, parts[i].fluid, density * q);
        drop.pressure_pa += part.pressure_pa;
        drop.slope_pa_s_g += density * part.slope_pa_s_g;
    }
    return drop;
}

void summarise(HydraulicElement& element, const std::vector<HydraulicPart>& parts, PressureLaw law,
               double loss_coefficient) {
    element.linear = 0.0;
    element.power = 0.0;
    element.quadratic = 0.0;
    element.laminar_limit_mm3_s = std::numeric_limits<double>::infinity();
    for (int i = element.first_part; i < element.first_part + element.part_count; ++i) {
        const auto& [cone, fluid] = parts[i];
        const double density = fluid.density_g_mm3;
        const DropCoefficients c = drop_coefficients(law, cone, fluid);
        element.linear += c.linear * density;
        if (c.power > 0.0) element.power += c.power * std::pow(density, 1.75);
        if (law == PressureLaw::regime)
            element.laminar_limit_mm3_s =
                std::min(element.laminar_limit_mm3_s, laminar_limit_g_s(cone, fluid) / density);
    }
    if (loss_coefficient > 0.0 && element.part_count > 0) {
        const auto& [cone, fluid] = parts[element.first_part];
        element.quadratic =
            bifurcation_loss(loss_coefficient, cone, fluid, fluid.density_g_mm3).pressure_pa;
    }
}

struct HydraulicSolver::Subtrees {
    std::vector<double> conductance;
    std::vector<double> drive;
};

// Every element's law linearised about its present flow: drop = intercept + slope * q.
struct HydraulicSolver::Linear {
    std::vector<double> slope;
    std::vector<double> intercept;
};

namespace {

// Sums the flow out of each node. Inflow and outflow of a node must agree exactly, so the largest
// outflow takes the rounding error.
struct Outflows {
    explicit Outflows(const HydraulicCircuit& circuit)
        : surplus(circuit.source_mm3_s),
          largest(circuit.node_count, -1),
          largest_flow(circuit.node_count, -1.0) {}

    void add(int node, int element, double outflow) {
        surplus[node] -= outflow;
        if (std::abs(outflow) > largest_flow[node]) {
            largest_flow[node] = std::abs(outflow);
            largest[node] = element;
        }
    }

    std::vector<double> surplus;
    std::vector<int> largest;
    std::vector<double> largest_flow;
};

// Solves a symmetric system (entries below the diagonal, diagonal) x = rhs. Scaling to a unit
// diagonal keeps conductances of 1e-30 and 1e30 in one matrix.
Eigen::VectorXd solve_scaled(std::vector<Eigen::Triplet<double>>& entries,
                             const std::vector<double>& diagonal, const Eigen::VectorXd& rhs) {
    const int count = static_cast<int>(diagonal.size());
    Eigen::VectorXd scale(count);
    for (int i = 0; i < count; ++i) {
        scale[i] = 1.0 / std::sqrt(diagonal[i]);
        entries.emplace_back(i, i, diagonal[i]);
    }
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SparseMatrix<double> unit = scale.asDiagonal() * matrix * scale.asDiagonal();
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(unit);
    const Eigen::VectorXd b = scale.cwiseProduct(rhs);
    Eigen::VectorXd x = factor.solve(b);
    x += factor.solve(b - unit.selfadjointView<Eigen::Lower>() * x);
    x = scale.cwiseProduct(x);
    if (!x.allFinite())
        throw InputError("the pressures cannot be told apart", "vessel network",
                         "Remove segments whose radii differ by many orders of magnitude");
    return x;
}

struct Incidence {
    std::vector<int> first;     // per node, and the end
    std::vector<int> elements;  // open ones at the node, in order
};

Incidence incidence_of(const HydraulicCircuit& circuit) {
    Incidence incidence;
    incidence.first.assign(circuit.node_count + 1, 0);
    for (const HydraulicElement& e : circuit.elements)
        if (e.open) {
            ++incidence.first[e.from + 1];
            ++incidence.first[e.to + 1];
        }
    for (int n = 0; n < circuit.node_count; ++n) incidence.first[n + 1] += incidence.first[n];
    incidence.elements.resize(incidence.first.back());
    std::vector<int> next(incidence.first.begin(), incidence.first.end() - 1);
    for (std::size_t i = 0; i < circuit.elements.size(); ++i) {
        const HydraulicElement& e = circuit.elements[i];
        if (!e.open) continue;
        incidence.elements[next[e.from]++] = static_cast<int>(i);
        incidence.elements[next[e.to]++] = static_cast<int>(i);
    }
    return incidence;
}

}  // namespace

HydraulicSolver::HydraulicSolver(const HydraulicCircuit& circuit) {
    const Incidence incidence = incidence_of(circuit);
    parent_element_.assign(circuit.node_count, -1);
    terminal_first_.assign(circuit.node_count + 1, 0);
    order_.reserve(circuit.node_count);
    std::vector<char> seen(circuit.node_count, 0);
    for (int root = 0; root < circuit.node_count; ++root) {
        if (seen[root] || is_fixed(circuit, root)) continue;
        seen[root] = 1;
        order_.push_back(root);
        for (std::size_t next = order_.size() - 1; next < order_.size(); ++next) {
            const int node = order_[next];
            for (int i = incidence.first[node]; i < incidence.first[node + 1]; ++i) {
                const int element = incidence.elements[i];
                if (element == parent_element_[node]) continue;
                const HydraulicElement& e = circuit.elements[element];
                const int other = e.from == node ? e.to : e.from;
                if (is_fixed(circuit, other)) {
                    ++terminal_first_[node + 1];
                } else if (!seen[other]) {
                    seen[other] = 1;
                    parent_element_[other] = element;
                    order_.push_back(other);
                } else {
                    loop_elements_.push_back(element);
                }
            }
        }
    }
    std::ranges::sort(loop_elements_);
    loop_elements_.erase(std::unique(loop_elements_.begin(), loop_elements_.end()),
                         loop_elements_.end());
    for (int n = 0; n < circuit.node_count; ++n) terminal_first_[n + 1] += terminal_first_[n];
    terminals_.resize(terminal_first_.back());
    std::vector<int> next(terminal_first_.begin(), terminal_first_.end() - 1);
    for (std::size_t i = 0; i < circuit.elements.size(); ++i) {
        const HydraulicElement& e = circuit.elements[i];
        if (!e.open) continue;
        const bool from_fixed = is_fixed(circuit, e.from);
        const bool to_fixed = is_fixed(circuit, e.to);
        if (from_fixed && to_fixed)
            between_fixed_.push_back(static_cast<int>(i));
        else if (from_fixed || to_fixed)
            terminals_[next[from_fixed ? e.to : e.from]++] = static_cast<int>(i);
    }
}

// From the leaves to the roots: reduces each subtree to an outflow of conductance * pressure -
// drive, as its parent sees it.
void HydraulicSolver::eliminate_tree(const HydraulicCircuit& circuit, const Linear& linear,
                                     const HydraulicState& next, Subtrees& subtrees) const {
    const std::vector<HydraulicElement>& elements = circuit.elements;
    std::vector<double>& conductance = subtrees.conductance;
    std::vector<double>& drive = subtrees.drive;
    conductance.assign(circuit.node_count, 0.0);
    drive = circuit.source_mm3_s;
    for (auto it = order_.rbegin(); it != order_.rend(); ++it) {
        const int node = *it;
        for (int i = terminal_first_[node]; i < terminal_first_[node + 1]; ++i) {
            const int id = terminals_[i];
            const bool outwards = elements[id].from == node;
            const double g = 1.0 / linear.slope[id];
            const double beyond = next.pressure_pa[outwards ? elements[id].to : elements[id].from];
            conductance[node] += g;
            drive[node] +=
                g * (outwards ? beyond + linear.intercept[id] : beyond - linear.intercept[id]);
        }
        const int id = parent_element_[node];
        if (id < 0) continue;
        const bool downwards = elements[id].to == node;
        const int parent = downwards ? elements[id].from : elements[id].to;
        const double offset = downwards ? linear.intercept[id] : -linear.intercept[id];
        const double g = 1.0 / linear.slope[id];
        const double passed = g / (conductance[node] + g);
        drive[parent] += passed * (conductance[node] * offset + drive[node]);
        conductance[parent] += passed * conductance[node];
    }
}

void HydraulicSolver::solve_tree(const HydraulicCircuit& circuit, const Linear& linear,
                                 HydraulicState& next) const {
    Subtrees subtrees;
    eliminate_tree(circuit, linear, next, subtrees);
    const std::vector<HydraulicElement>& elements = circuit.elements;
    const auto& [conductance, drive] = subtrees;
    Outflows outflows(circuit);
    for (const int node : order_) {
        const int id = parent_element_[node];
        if (id < 0) {
            if (conductance[node] == 0.0 && drive[node] != 0.0) reject_no_way_out(drive[node]);
            next.pressure_pa[node] =
                conductance[node] > 0.0 ? drive[node] / conductance[node] : 0.0;
        } else {
            const bool downwards = elements[id].to == node;
            const int parent = downwards ? elements[id].from : elements[id].to;
            const double head = next.pressure_pa[parent] -
                                (downwards ? linear.intercept[id] : -linear.intercept[id]);
            const double g = 1.0 / linear.slope[id];
            const double passed = g / (conductance[node] + g);
            const double inflow = passed * (conductance[node] * head - drive[node]);
            next.pressure_pa[node] = (drive[node] + g * head) / (conductance[node] + g);
            next.flow_mm3_s[id] = downwards ? inflow : -inflow;
            outflows.add(parent, id, inflow);
        }
        for (int i = terminal_first_[node]; i < terminal_first_[node + 1]; ++i) {
            const int t = terminals_[i];
            const HydraulicElement& e = elements[t];
            const double difference = next.pressure_pa[e.from] - next.pressure_pa[e.to];
            next.flow_mm3_s[t] = (difference - linear.intercept[t]) / linear.slope[t];
            outflows.add(node, t, e.from == node ? next.flow_mm3_s[t] : -next.flow_mm3_s[t]);
        }
    }
    for (const int node : order_) {
        const int in = parent_element_[node];
        if (in >= 0)
            outflows.surplus[node] +=
                elements[in].to == node ? next.flow_mm3_s[in] : -next.flow_mm3_s[in];
        const int out = outflows.largest[node];
        if (out >= 0)
            next.flow_mm3_s[out] +=
                elements[out].from == node ? outflows.surplus[node] : -outflows.surplus[node];
    }
}

// A component without a fixed pressure floats: its root is tied to the rest pressure, 0.
void HydraulicSolver::tie_floating(const HydraulicCircuit& circuit,
                                   std::vector<double>& diagonal) const {
    const int count = static_cast<int>(order_.size());
    for (int begin = 0; begin < count;) {
        int end = begin + 1;
        while (end < count && parent_element_[order_[end]] >= 0) ++end;
        bool grounded = false;
        double source = 0.0;
        for (int i = begin; i < end; ++i) {
            grounded |= terminal_first_[order_[i] + 1] > terminal_first_[order_[i]];
            source += circuit.source_mm3_s[order_[i]];
        }
        if (!grounded) {
            if (source != 0.0) reject_no_way_out(source);
            diagonal[begin] += diagonal[begin] > 0.0 ? diagonal[begin] : 1.0;
        }
        begin = end;
    }
}

void HydraulicSolver::solve_graph(const HydraulicCircuit& circuit, const Linear& linear,
                                  HydraulicState& next) const {
    const int count = static_cast<int>(order_.size());
    std::vector<int> row(circuit.node_count, -1);
    for (int i = 0; i < count; ++i) row[order_[i]] = i;
    Eigen::VectorXd rhs(count);
    std::vector<double> diagonal(count, 0.0);
    for (int i = 0; i < count; ++i) rhs[i] = circuit.source_mm3_s[order_[i]];
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(circuit.elements.size() + count);
    for (std::size_t id = 0; id < circuit.elements.size(); ++id) {
        const HydraulicElement& e = circuit.elements[id];
        if (!e.open) continue;
        const double g = 1.0 / linear.slope[id];
        const double offset = g * linear.intercept[id];
        for (const bool outwards : {true, false}) {
            const int here = row[outwards ? e.from : e.to];
            if (here < 0) continue;
            const int other = outwards ? e.to : e.from;
            diagonal[here] += g;
            rhs[here] += outwards ? offset : -offset;
            if (row[other] < 0)
                rhs[here] += g * next.pressure_pa[other];
            else if (row[other] < here)
                entries.emplace_back(here, row[other], -g);
        }
    }
    tie_floating(circuit, diagonal);
    const Eigen::VectorXd x = solve_scaled(entries, diagonal, rhs);
    for (int i = 0; i < count; ++i) next.pressure_pa[order_[i]] = x[i];
    for (std::size_t id = 0; id < circuit.elements.size(); ++id) {
        const HydraulicElement& e = circuit.elements[id];
        if (!e.open) continue;
        const double difference = next.pressure_pa[e.from] - next.pressure_pa[e.to];
        next.flow_mm3_s[id] = (difference - linear.intercept[id]) / linear.slope[id];
    }
    balance_graph(circuit, next);
}

// Flow runs from high to low total pressure. Nodes are visited in that order, so that the inflow of
// each is complete before its outflow is balanced against it, as on a tree.
void HydraulicSolver::balance_graph(const HydraulicCircuit& circuit, HydraulicState& next) const {
    const Incidence incidence = incidence_of(circuit);
    std::vector<int> falling = order_;
    std::ranges::stable_sort(falling, std::ranges::greater{},
                             [&](int node) { return next.pressure_pa[node]; });
    std::vector<int> rank(circuit.node_count, circuit.node_count);  // fixed nodes come last
    for (std::size_t i = 0; i < falling.size(); ++i) rank[falling[i]] = static_cast<int>(i);
    for (const int node : falling) {
        double surplus = circuit.source_mm3_s[node];
        int out = -1;
        for (int i = incidence.first[node]; i < incidence.first[node + 1]; ++i) {
            const int id = incidence.elements[i];
            const HydraulicElement& e = circuit.elements[id];
            const bool outwards = e.from == node;
            surplus -= outwards ? next.flow_mm3_s[id] : -next.flow_mm3_s[id];
            const bool later = rank[outwards ? e.to : e.from] > rank[node];
            if (later &&
                (out < 0 || std::abs(next.flow_mm3_s[id]) > std::abs(next.flow_mm3_s[out])))
                out = id;
        }
        if (out >= 0)
            next.flow_mm3_s[out] += circuit.elements[out].from == node ? surplus : -surplus;
    }
}

void HydraulicSolver::linear_solve(const HydraulicCircuit& circuit, const Linear& linear,
                                   HydraulicState& next) const {
    if (loop_elements_.empty())
        solve_tree(circuit, linear, next);
    else
        solve_graph(circuit, linear, next);
    for (const int id : between_fixed_) {
        const HydraulicElement& e = circuit.elements[id];
        const double difference = next.pressure_pa[e.from] - next.pressure_pa[e.to];
        next.flow_mm3_s[id] = (difference - linear.intercept[id]) / linear.slope[id];
    }
}

void HydraulicSolver::evaluate(const HydraulicCircuit& circuit, const std::vector<double>& flow,
                               std::vector<Drop>& drops) const {
    for (std::size_t i = 0; i < flow.size(); ++i)
        if (circuit.elements[i].open)
            drops[i] = drop_of(circuit.elements[i], circuit.parts, flow[i]);
}

// The dissipation is convex along the step from `flow` to `full` and falls at its start. Shortens
// the step until the slope at its end is at most half of that at its start, in absolute value.
void HydraulicSolver::line_search(const HydraulicCircuit& circuit, const Linear& linear,
                                  const std::vector<double>& full, std::vector<double>& flow,
                                  std::vector<Drop>& drops) const {
    const std::size_t count = flow.size();
    double steepness = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double change = full[i] - flow[i];
        steepness += linear.slope[i] * change * change;
    }
    std::vector<double> trial = full;
    double low = 0.0;
    double high = 1.0;
    double at = 1.0;
    for (int attempt = 0; attempt < maximum_line_search_steps; ++attempt) {
        double slope = 0.0;
        for (std::size_t i = 0; i < count; ++i) {
            const double predicted = linear.intercept[i] + linear.slope[i] * full[i];
            slope += (drops[i].pressure_pa - predicted) * (full[i] - flow[i]);
        }
        if (std::abs(slope) <= 0.5 * steepness) break;
        (slope > 0.0 ? high : low) = at;
        if (low == 1.0) break;
        at = 0.5 * (low + high);
        for (std::size_t i = 0; i < count; ++i) trial[i] = flow[i] + at * (full[i] - flow[i]);
        evaluate(circuit, trial, drops);
    }
    flow = std::move(trial);
}

HydraulicState HydraulicSolver::solve(const HydraulicCircuit& circuit, double rest_pressure_pa,
                                      const std::vector<double>* guess) const {
    const std::size_t count = circuit.elements.size();
    std::vector<double> flow(count, 0.0);
    if (guess)
        for (std::size_t i = 0; i < count; ++i)
            if (circuit.elements[i].open) flow[i] = (*guess)[i];
    std::vector<Drop> drops(count);
    evaluate(circuit, flow, drops);
    Linear linear{std::vector<double>(count), std::vector<double>(count)};
    // Pressures are relative to the rest pressure, so that a part at rest stays exactly at rest.
    HydraulicState next{std::vector<double>(count, 0.0),
                        std::vector<double>(circuit.node_count, 0.0), 0};
    for (int n = 0; n < circuit.node_count; ++n)
        if (is_fixed(circuit, n))
            next.pressure_pa[n] = circuit.fixed_pressure_pa[n] - rest_pressure_pa;
    for (int step = 1; step <= maximum_newton_steps; ++step) {
        for (std::size_t i = 0; i < count; ++i) {
            linear.slope[i] = drops[i].slope_pa_s_g;
            linear.intercept[i] = drops[i].pressure_pa - linear.slope[i] * flow[i];
        }
        linear_solve(circuit, linear, next);
        evaluate(circuit, next.flow_mm3_s, drops);
        double highest = 0.0;
        for (const Drop& drop : drops) highest = std::max(highest, std::abs(drop.pressure_pa));
        bool converged = true;
        for (std::size_t i = 0; i < count && converged; ++i) {
            const double drop = drops[i].pressure_pa;
            const double predicted = linear.intercept[i] + linear.slope[i] * next.flow_mm3_s[i];
            converged = std::abs(drop - predicted) <= 1e-12 * std::abs(drop) + 1e-15 * highest;
        }
        next.newton_steps = step;
        if (converged) {
            for (int n = 0; n < circuit.node_count; ++n)
                next.pressure_pa[n] = is_fixed(circuit, n) ? circuit.fixed_pressure_pa[n]
                                                           : next.pressure_pa[n] + rest_pressure_pa;
            return next;
        }
        line_search(circuit, linear, next.flow_mm3_s, flow, drops);
    }
    throw InputError(
        "the flow did not settle after " + std::to_string(maximum_newton_steps) + " Newton steps",
        "vessel network", "Check the radii and the flow for values out of range");
}

}  // namespace hepatica
