// SPDX-License-Identifier: GPL-3.0-or-later
// Implements max-product and sum-product message passing on the portal tree with nine states.
#include "core/tree/territories/couinaud_branches.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hepatica {

namespace {

// State 0: the branch supplies several segments; 1 to 8: that segment.
constexpr int states = couinaud_count + 1;
using Potentials = std::array<double, states>;  // logarithms

constexpr double impossible = -std::numeric_limits<double>::infinity();

double transition(int parent, int child) {
    if (parent == child) return 0.0;
    // A branch of one segment does not divide into common branches, and branches of other segments
    // do not arise from the caudate lobe's, which are the smallest.
    if (child == 0 || parent == 1) return impossible;
    return parent == 0 ? -branch_chain::leaving : -branch_chain::changing;
}

// Evidence for each state of a branch: log likelihood integrated over its length in mm.
Potentials evidence_of(const VesselSegment& segment, const CouinaudFrame& frame) {
    using branch_chain::least;
    Potentials evidence{};
    for (std::size_t i = 1; i < segment.points_mm.size(); ++i) {
        const Vec3 &from = segment.points_mm[i - 1], &to = segment.points_mm[i];
        const auto likelihood = segment_likelihoods(frame, 0.5 * (from + to));
        const double length = (to - from).norm();
        double most = least;
        for (int k = 1; k < states; ++k) {
            most = std::max(most, likelihood[k - 1]);
            evidence[k] += length * std::log(std::max(likelihood[k - 1], least));
        }
        evidence[0] += length * std::log(branch_chain::common * most);
    }
    return evidence;
}

struct Chain {
    std::vector<int> portal;  // segments, parents before children
    std::vector<int> parent;  // of each segment; -1: no portal parent
    std::vector<Potentials> evidence;
};

Chain chain_of(const VesselTree& tree, const CouinaudFrame& frame) {
    Chain chain;
    chain.parent.assign(tree.segments.size(), -1);
    chain.evidence.resize(tree.segments.size());
    std::vector<bool> divides(tree.segments.size(), false);
    double whole_mm = 0.0;
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        const VesselSegment& segment = tree.segments[s];
        if (segment.system != VascularSystem::portal) continue;
        chain.portal.push_back(static_cast<int>(s));
        whole_mm += length_mm(segment);
        const int above = segment.parent;
        if (above < 0 || tree.segments[above].system != VascularSystem::portal) continue;
        chain.parent[s] = above;
        divides[above] = true;
    }
    for (const int s : chain.portal) {
        Potentials& evidence = chain.evidence[s];
        evidence = evidence_of(tree.segments[s], frame);
        for (double& one : evidence) one /= branch_chain::witness_share * whole_mm;
        if (!divides[s]) evidence[0] = impossible;
    }
    for (int s = frame.trunk; s >= 0; s = chain.parent[s])
        if (divides[s])
            std::fill(chain.evidence[s].begin() + 1, chain.evidence[s].end(), impossible);
    return chain;
}

double log_sum(const Potentials& values) {
    const double most = *std::ranges::max_element(values);
    if (most == impossible) return impossible;
    double sum = 0.0;
    for (const double value : values) sum += std::exp(value - most);
    return most + std::log(sum);
}

// Message of a child to each state of its parent; `best` combines the child's states.
template <class Best>
Potentials message_up(const Potentials& belief, Best&& best) {
    Potentials message;
    for (int above = 0; above < states; ++above) {
        Potentials options;
        for (int k = 0; k < states; ++k) options[k] = belief[k] + transition(above, k);
        message[above] = best(options);
    }
    return message;
}

template <class Best>
std::vector<Potentials> beliefs_from_below(const Chain& chain, Best&& best) {
    std::vector<Potentials> belief = chain.evidence;
    for (auto s = chain.portal.rbegin(); s != chain.portal.rend(); ++s) {
        if (chain.parent[*s] < 0) continue;
        const Potentials message = message_up(belief[*s], best);
        for (int k = 0; k < states; ++k) belief[chain.parent[*s]][k] += message[k];
    }
    return belief;
}

// The first of equal values.
int most_likely(const Potentials& values) {
    return static_cast<int>(std::ranges::max_element(values) - values.begin());
}

std::vector<int> most_likely_states(const Chain& chain) {
    const auto belief = beliefs_from_below(
        chain, [](const Potentials& options) { return *std::ranges::max_element(options); });
    std::vector<int> state(chain.parent.size(), 0);
    for (const int s : chain.portal) {
        Potentials options = belief[s];
        if (const int above = chain.parent[s]; above >= 0)
            for (int k = 0; k < states; ++k) options[k] += transition(state[above], k);
        state[s] = most_likely(options);
    }
    return state;
}

// A common branch whose branches all supply one segment gets that segment, too.
void close_up(const Chain& chain, std::vector<BranchLabel>& labels) {
    constexpr int several = -1;
    std::vector<BranchLabel> below(labels.size(), BranchLabel{0, 1.0});
    for (auto s = chain.portal.rbegin(); s != chain.portal.rend(); ++s) {
        if (labels[*s].segment == 0 && below[*s].segment > 0) labels[*s] = below[*s];
        if (chain.parent[*s] < 0) continue;
        BranchLabel& above = below[chain.parent[*s]];
        const bool agrees = above.segment == 0 || above.segment == labels[*s].segment;
        above.segment = agrees && labels[*s].segment != 0 ? labels[*s].segment : several;
        above.confidence = std::min(above.confidence, labels[*s].confidence);
    }
}

// Probability of each state of each branch.
std::vector<Potentials> marginals(const Chain& chain) {
    const auto sum = [](const Potentials& options) { return log_sum(options); };
    const std::vector<Potentials> below = beliefs_from_below(chain, sum);
    std::vector<Potentials> all = below;
    for (const int s : chain.portal) {
        const int above = chain.parent[s];
        if (above >= 0) {
            // The parent's belief without this branch's own message.
            const Potentials told = message_up(below[s], sum);
            Potentials rest;
            for (int k = 0; k < states; ++k)
                rest[k] = all[above][k] == impossible ? impossible : all[above][k] - told[k];
            for (int k = 0; k < states; ++k) {
                Potentials options;
                for (int j = 0; j < states; ++j) options[j] = rest[j] + transition(j, k);
                all[s][k] += log_sum(options);
            }
        }
        const double total = log_sum(all[s]);
        for (double& one : all[s]) one -= total;
    }
    return all;
}

}  // namespace

std::vector<BranchLabel> label_branches(const VesselTree& tree, const CouinaudFrame& frame) {
    const Chain chain = chain_of(tree, frame);
    const std::vector<int> state = most_likely_states(chain);
    const std::vector<Potentials> probability = marginals(chain);
    std::vector<BranchLabel> labels(tree.segments.size());
    for (const int s : chain.portal)
        labels[s] = {state[s], std::clamp(std::exp(probability[s][state[s]]), 0.0, 1.0)};
    close_up(chain, labels);
    return labels;
}

}  // namespace hepatica
