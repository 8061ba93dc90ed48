// SPDX-License-Identifier: GPL-3.0-or-later
// Steady flow in a circuit of nonlinear resistances: Newton on the node pressures with the flows as
// the primary unknowns (the global gradient algorithm of Todini and Pilati, 1988), a line search on
// the convex dissipation, O(elements) elimination where the circuit is a tree, otherwise sparse
// LDL^T.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "core/flow/pressure_drop.h"

namespace hepatica {

// A piece of lumen and the fluid that fills it.
struct HydraulicPart {
    Cone cone;
    Fluid fluid;
};

// drop(q) = q (linear + power |q|^0.75 + quadratic |q|), where q is the volume flow in mm3/s from
// `from` to `to`. Where |q| > laminar_limit, the laws of the parts replace `linear` and `power`.
struct HydraulicElement {
    int from = -1;
    int to = -1;
    double linear = 0.0;
    double power = 0.0;
    double quadratic = 0.0;
    double laminar_limit_mm3_s = std::numeric_limits<double>::infinity();
    int first_part = 0;
    int part_count = 0;
    bool open = true;
};

// The element's pressure drop and its slope with respect to the volume flow.
Drop drop_of(const HydraulicElement& element, const std::vector<HydraulicPart>& parts, double q);

// Sums the laws of parts [first_part, first_part + part_count) into the element's coefficients.
// loss_coefficient multiplies the dynamic pressure at the proximal end of the first part.
void summarise(HydraulicElement& element, const std::vector<HydraulicPart>& parts, PressureLaw law,
               double loss_coefficient);

struct HydraulicCircuit {
    int node_count = 0;
    std::vector<HydraulicElement> elements;
    std::vector<HydraulicPart> parts;
    std::vector<double> source_mm3_s;       // per node: volume flow injected there
    std::vector<double> fixed_pressure_pa;  // per node; NaN: the node is free

    explicit HydraulicCircuit(int nodes)
        : node_count(nodes),
          source_mm3_s(nodes, 0.0),
          fixed_pressure_pa(nodes, std::numeric_limits<double>::quiet_NaN()) {}
};

struct HydraulicState {
    std::vector<double> flow_mm3_s;   // per element, positive from `from` to `to`
    std::vector<double> pressure_pa;  // per node; total pressure
    int newton_steps = 0;
};

// Solves a circuit, and again after its elements' laws, sources or fixed pressures have changed;
// the order of elimination is found once. The open elements and the fixed nodes must not change;
// make another solver then. Not thread-safe; several solvers may run side by side.
class HydraulicSolver {
  public:
    explicit HydraulicSolver(const HydraulicCircuit& circuit);

    // Starts from `guess` (flows of a similar circuit) where given, otherwise from the laminar
    // solution. A component without a fixed pressure and without a source is at rest at
    // `rest_pressure_pa`; all pressures are computed relative to it. Throws InputError where a
    // source has no way out or Newton does not converge.
    HydraulicState solve(const HydraulicCircuit& circuit, double rest_pressure_pa,
                         const std::vector<double>* guess = nullptr) const;

  private:
    struct Linear;
    struct Subtrees;
    void linear_solve(const HydraulicCircuit& circuit, const Linear& linear,
                      HydraulicState& next) const;
    void eliminate_tree(const HydraulicCircuit& circuit, const Linear& linear,
                        const HydraulicState& next, Subtrees& subtrees) const;
    void solve_tree(const HydraulicCircuit& circuit, const Linear& linear,
                    HydraulicState& next) const;
    void tie_floating(const HydraulicCircuit& circuit, std::vector<double>& diagonal) const;
    void solve_graph(const HydraulicCircuit& circuit, const Linear& linear,
                     HydraulicState& next) const;
    void balance_graph(const HydraulicCircuit& circuit, HydraulicState& next) const;
    void evaluate(const HydraulicCircuit& circuit, const std::vector<double>& flow,
                  std::vector<Drop>& drops) const;
    void line_search(const HydraulicCircuit& circuit, const Linear& linear,
                     const std::vector<double>& full, std::vector<double>& flow,
                     std::vector<Drop>& drops) const;

    std::vector<int> order_;           // free nodes, a parent before its children
    std::vector<int> parent_element_;  // per node; -1 at the root of a component
    std::vector<int> terminal_first_;  // per node, and the end: into terminals_
    std::vector<int> terminals_;       // elements that end in a fixed node
    std::vector<int> loop_elements_;   // between free nodes, not in the spanning forest
    std::vector<int> between_fixed_;   // both ends fixed
};

}  // namespace hepatica
