// SPDX-License-Identifier: GPL-3.0-or-later
// Implements alpha expansion with the maximum flow algorithm of Boykov and Kolmogorov (Boost).
#include "core/tree/systems/potts_labelling.h"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <cassert>

namespace hepatica {

namespace {

using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
using FlowGraph = boost::adjacency_list<
    boost::vecS, boost::vecS, boost::directedS,
    boost::property<
        boost::vertex_color_t, boost::default_color_type,
        boost::property<boost::vertex_distance_t, long,
                        boost::property<boost::vertex_predecessor_t, Traits::edge_descriptor>>>,
    boost::property<
        boost::edge_capacity_t, double,
        boost::property<boost::edge_residual_capacity_t, double,
                        boost::property<boost::edge_reverse_t, Traits::edge_descriptor>>>>;

// One expansion: the sites on the sink's side of a minimal cut change to one label.
class Expansion {
  public:
    Expansion(const PottsProblem& problem, const std::vector<int>& labels, int label)
        : flow_(problem.costs.size() + 2),
          source_(problem.costs.size()),
          sink_(problem.costs.size() + 1),
          stay_(problem.costs.size()),
          change_(problem.costs.size()) {
        for (std::size_t i = 0; i < stay_.size(); ++i) {
            stay_[i] = problem.costs[i][labels[i]];
            change_[i] = problem.costs[i][label];
        }
        for (const Tie& tie : problem.ties) add(tie, labels, label);
        for (std::size_t i = 0; i < stay_.size(); ++i) {
            // A site that stays cuts its arc to the sink, one that changes that from the source;
            // only the difference matters.
            const double least = std::min(stay_[i], change_[i]);
            connect(source_, i, change_[i] - least);
            connect(i, sink_, stay_[i] - least);
        }
    }

    std::vector<std::uint8_t> changed() {
        boost::boykov_kolmogorov_max_flow(flow_, source_, sink_);
        // Sites on neither side may have either label; they keep theirs.
        const auto colour = boost::get(boost::vertex_color, flow_);
        const auto sink_colour = colour[sink_];
        std::vector<std::uint8_t> changes(stay_.size());
        for (std::size_t i = 0; i < changes.size(); ++i)
            changes[i] = colour[i] == sink_colour ? 1 : 0;
        return changes;
    }

  private:
    // Pairwise energies as in Kolmogorov and Zabih (2004), with A, B, C, D for (stay, stay), (stay,
    // change), (change, stay) and (change, change), where D = 0.
    void add(const Tie& tie, const std::vector<int>& labels, int label) {
        const double a = labels[tie.a] != labels[tie.b] ? tie.strength : 0.0;
        const double b = labels[tie.a] != label ? tie.strength : 0.0;
        const double c = labels[tie.b] != label ? tie.strength : 0.0;
        stay_[tie.a] += a;
        change_[tie.a] += c;
        change_[tie.b] -= c;
        assert(b + c - a >= -1e-12);
        connect(tie.a, tie.b, std::max(0.0, b + c - a));
    }

    void connect(std::size_t from, std::size_t to, double capacity) {
        if (capacity <= 0.0) return;
        const auto forward = boost::add_edge(from, to, flow_).first;
        const auto backward = boost::add_edge(to, from, flow_).first;
        boost::put(boost::edge_capacity, flow_, forward, capacity);
        boost::put(boost::edge_capacity, flow_, backward, 0.0);
        boost::put(boost::edge_reverse, flow_, forward, backward);
        boost::put(boost::edge_reverse, flow_, backward, forward);
    }

    FlowGraph flow_;
    std::size_t source_;
    std::size_t sink_;
    std::vector<double> stay_, change_;
};

}  // namespace

double energy_of(const PottsProblem& problem, const std::vector<int>& labels) {
    double energy = 0.0;
    for (std::size_t i = 0; i < labels.size(); ++i) energy += problem.costs[i][labels[i]];
    for (const Tie& tie : problem.ties)
        if (labels[tie.a] != labels[tie.b]) energy += tie.strength;
    return energy;
}

std::vector<int> least_energy_labels(const PottsProblem& problem, const Job& job) {
    std::vector<int> labels(problem.costs.size(), 0);
    double energy = energy_of(problem, labels);
    for (int unimproved = 0, label = 1; unimproved < problem.labels;
         label = (label + 1) % problem.labels) {
        job.throw_if_cancelled();
        const std::vector<std::uint8_t> changed = Expansion(problem, labels, label).changed();
        std::vector<int> next = labels;
        for (std::size_t i = 0; i < next.size(); ++i)
            if (changed[i] != 0) next[i] = label;
        const double next_energy = energy_of(problem, next);
        if (next_energy < energy - 1e-9) {
            labels = std::move(next);
            energy = next_energy;
            unimproved = 0;
        }
        ++unimproved;
    }
    return labels;
}

}  // namespace hepatica
