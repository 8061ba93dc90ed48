// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/drug_front.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

#include "core/base/error.h"

namespace hepatica {

namespace {

constexpr double same_share = 1e-12;    // smaller differences of shares are rounding
constexpr double same_time = 1e-9;      // of the time: smaller differences are rounding
constexpr double empty_volume = 1e-13;  // of a segment's volume: such a piece has left
constexpr double resting_flow = 1e-14;  // of the total inflow: rounding of the solution
constexpr int most_rejections = 20;

}  // namespace

DrugFront::DrugFront(FlowNetwork network, FlowConditions conditions, int drug_inlet,
                     const FrontOptions& options, std::vector<int> outlets)
    : network_(std::move(network)),
      conditions_(std::move(conditions)),
      options_(options),
      drug_inlet_(drug_inlet),
      outlets_(outlets.empty() ? network_.outlet_nodes : std::move(outlets)) {
    if (drug_inlet_ < 0 || drug_inlet_ >= static_cast<int>(conditions_.inlets.size()))
        throw InputError("there is no inlet " + std::to_string(drug_inlet), "injection",
                         "Say where the drug enters");
    if (!(options_.step_tolerance > 0.0) || !(options_.concentration_tolerance >= 0.0) ||
        !(options_.injection_end_s >= 0.0))
        throw InputError("a tolerance or time of the injection is negative", "injection",
                         "Give positive values");
    drug_ = conditions_.inlets[drug_inlet_].fluid;
    const std::size_t count = network_.segments.size();
    volume_mm3_.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        volume_mm3_.push_back(volume_mm3(network_, static_cast<int>(i)));
    slugs_.resize(count);
    reached_from_proximal_.resize(count);
    reached_from_distal_.resize(count);
    node_share_.resize(network_.node_count);
    node_surplus_.resize(network_.node_count);
    outlet_mass_g_.assign(outlets_.size(), 0.0);
    flow_ = std::make_unique<NetworkFlow>(network_, conditions_);
    flow_->solve();
    if (options_.injection_end_s == 0.0) end_injection();
    look_ahead();
}

double DrugFront::share_at(int segment, bool distal_end) const {
    const Slugs& slugs = slugs_[segment];
    if (slugs.empty()) return 0.0;
    return distal_end ? slugs.back().share : slugs.front().share;
}

// Time until a boundary reaches the end of its segment; the boundary may be inside or about to
// enter. Shares that differ by less than `tolerance` make no boundary. Requires mix_at_nodes() of
// these flows.
double DrugFront::time_to_event(const std::vector<double>& flow, double tolerance) const {
    double soonest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < flow.size(); ++i) {
        const double q = flow[i];
        if (std::abs(q) <= negligible_mm3_s_) continue;
        const Slugs& slugs = slugs_[i];
        double volume = volume_mm3_[i];
        if (slugs.size() > 1) {
            volume = q > 0.0 ? slugs.back().volume_mm3 : slugs.front().volume_mm3;
        } else {
            const FlowSegment& s = network_.segments[i];
            const double share = node_share_[q > 0.0 ? s.proximal_node : s.distal_node];
            if (std::abs(share - share_at(static_cast<int>(i), false)) <= tolerance) continue;
        }
        soonest = std::min(soonest, volume / std::abs(q));
    }
    return soonest;
}

void DrugFront::mix_at_nodes(const Flows& flows) {
    std::vector<double> inflow(network_.node_count, 0.0);
    std::vector<double> outflow(network_.node_count, 0.0);
    std::vector<double> drug_inflow(network_.node_count, 0.0);
    double entering = 0.0;
    for (std::size_t i = 0; i < conditions_.inlets.size(); ++i) {
        const int node = conditions_.inlets[i].node;
        const double q = flows.inlet_mm3_s[i];
        entering += std::abs(q);
        (q > 0.0 ? inflow : outflow)[node] += std::abs(q);
        if (q > 0.0 && static_cast<int>(i) == drug_inlet_) drug_inflow[node] += q;
    }
    negligible_mm3_s_ = resting_flow * entering;
    for (std::size_t i = 0; i < network_.segments.size(); ++i) {
        const double q = flows.segment_mm3_s[i];
        if (std::abs(q) <= negligible_mm3_s_) continue;
        const FlowSegment& s = network_.segments[i];
        const int to = q > 0.0 ? s.distal_node : s.proximal_node;
        outflow[q > 0.0 ? s.proximal_node : s.distal_node] += std::abs(q);
        inflow[to] += std::abs(q);
        drug_inflow[to] += std::abs(q) * share_at(static_cast<int>(i), q > 0.0);
    }
    for (int n = 0; n < network_.node_count; ++n) {
        // Where more flows out into segments than arrives from segments, the rest enters through an
        // outlet.
        const double through = outflow[n] > inflow[n] * (1.0 + 1e-9) ? outflow[n] : inflow[n];
        node_share_[n] = through > 0.0 ? drug_inflow[n] / through : 0.0;
        node_surplus_[n] = inflow[n] - outflow[n];
    }
}

void DrugFront::push(int segment, double volume, bool from_proximal, double share) {
    Slugs& slugs = slugs_[segment];
    if (slugs.empty()) slugs.push_back({volume_mm3_[segment], 0.0});
    Slug& leaving = from_proximal ? slugs.back() : slugs.front();
    leaving.volume_mm3 -= volume;
    if (slugs.size() > 1 && leaving.volume_mm3 <= empty_volume * volume_mm3_[segment]) {
        const double rest = leaving.volume_mm3;
        if (from_proximal)
            slugs.pop_back();
        else
            slugs.erase(slugs.begin());
        (from_proximal ? slugs.back() : slugs.front()).volume_mm3 += rest;
    }
    Slug& entry = from_proximal ? slugs.front() : slugs.back();
    if (std::abs(entry.share - share) <= std::max(same_share, options_.concentration_tolerance)) {
        const double sum = entry.volume_mm3 + volume;
        if (std::abs(entry.share - share) > same_share)
            entry.share += (share - entry.share) * (volume / sum);
        entry.volume_mm3 = sum;
    } else if (from_proximal) {
        slugs.insert(slugs.begin(), {volume, share});
    } else {
        slugs.push_back({volume, share});
    }
}

void DrugFront::move(const Flows& flows, double duration_s, std::vector<Saved>* saved) {
    mix_at_nodes(flows);
    touched_.clear();
    for (std::size_t i = 0; i < network_.segments.size(); ++i) {
        const double q = flows.segment_mm3_s[i];
        if (std::abs(q) <= negligible_mm3_s_) continue;
        const int id = static_cast<int>(i);
        const FlowSegment& s = network_.segments[i];
        const double share = node_share_[q > 0.0 ? s.proximal_node : s.distal_node];
        if (slugs_[i].size() < 2 && std::abs(share - share_at(id, false)) <= same_share) continue;
        if (saved) saved->push_back({id, slugs_[i]});
        touched_.push_back(id);
        push(id, std::abs(q) * duration_s, q > 0.0, share);
    }
}

void DrugFront::refill(const std::vector<int>& segments) {
    std::vector<Filling> fillings;
    for (const int id : segments) {
        fillings.clear();
        for (const Slug& slug : slugs_[id])
            fillings.push_back({slug.volume_mm3, blend(conditions_.resident, drug_, slug.share)});
        if (fillings.empty()) fillings.push_back({volume_mm3_[id], conditions_.resident});
        flow_->fill(id, fillings);
    }
}

// Heun's rule: the mean of the flows now and after `duration_s` at these flows. Shortens the
// duration until the two differ by no more than the tolerance.
DrugFront::Flows DrugFront::predict(double& duration_s) {
    const Flows now{flow().volume_flow_mm3_s, flow().inlet_flow_mm3_s};
    double entering = 0.0;
    for (const double q : now.inlet_mm3_s) entering += std::abs(q);
    for (int attempt = 0;; ++attempt) {
        std::vector<Saved> saved;
        move(now, duration_s, &saved);
        refill(touched_);
        const FlowSolution& then = flow_->solve();
        for (Saved& s : saved) slugs_[s.segment] = std::move(s.slugs);
        Flows mean = now;
        double change = 0.0;
        for (std::size_t i = 0; i < mean.segment_mm3_s.size(); ++i) {
            change = std::max(change, std::abs(then.volume_flow_mm3_s[i] - mean.segment_mm3_s[i]));
            mean.segment_mm3_s[i] = 0.5 * (mean.segment_mm3_s[i] + then.volume_flow_mm3_s[i]);
        }
        for (std::size_t i = 0; i < mean.inlet_mm3_s.size(); ++i)
            mean.inlet_mm3_s[i] = 0.5 * (mean.inlet_mm3_s[i] + then.inlet_flow_mm3_s[i]);
        const double error = entering > 0.0 ? change / entering : 0.0;
        if (error <= options_.step_tolerance || attempt == most_rejections) {
            // A step that an event shortened is no reason to keep later ones short.
            suggested_s_ = attempt == 0 ? std::max(suggested_s_, 2.0 * duration_s) : duration_s;
            return mean;
        }
        duration_s *= std::max(0.1, 0.8 * options_.step_tolerance / error);
        refill(touched_);
    }
}

void DrugFront::count(const Flows& flows, double duration_s) {
    for (std::size_t i = 0; i < conditions_.inlets.size(); ++i) {
        const double volume = flows.inlet_mm3_s[i] * duration_s;
        if (volume < 0.0)
            left_mm3_ -= volume * node_share_[conditions_.inlets[i].node];
        else if (static_cast<int>(i) == drug_inlet_)
            injected_mm3_ += volume;
    }
    const auto leaving = [&](int node) {
        return std::max(node_surplus_[node], 0.0) * duration_s * node_share_[node];
    };
    // Nothing leaves at the node of an outlet that is torn off.
    for (std::size_t o = 0; o < outlets_.size(); ++o) {
        const double volume = leaving(outlets_[o]);
        left_mm3_ += volume;
        outlet_mass_g_[o] += volume * drug_.density_g_mm3;
    }
    for (const int node : network_.torn_nodes) bled_mm3_ += leaving(node);
}

// What the flow has brought from the other end before it turned is behind `limit` and does not
// count.
std::optional<double> DrugFront::leading_edge_mm3(int id, bool forwards, double limit) const {
    const double threshold = std::max(same_share, options_.concentration_tolerance);
    const double sliver = 10.0 * empty_volume * volume_mm3_[id];
    const Slugs& slugs = slugs_[id];
    double untouched = 0.0;  // from the far end on
    for (std::size_t i = 0; i < slugs.size(); ++i) {
        const Slug& slug = forwards ? slugs[slugs.size() - 1 - i] : slugs[i];
        const double edge = forwards ? volume_mm3_[id] - untouched : untouched;
        untouched += slug.volume_mm3;
        const double counts = forwards ? std::min(edge, limit) - (volume_mm3_[id] - untouched)
                                       : untouched - std::max(edge, limit);
        if (slug.share > threshold && counts > sliver) return edge;
    }
    return std::nullopt;
}

void DrugFront::note_arrivals(const Flows& flows, double begin_s) {
    for (const int id : touched_) {
        const double flow = flows.segment_mm3_s[id], begin = flow > 0.0 ? 0.0 : volume_mm3_[id];
        const bool forwards = flow > 0.0;
        auto& knots = forwards ? reached_from_proximal_[id] : reached_from_distal_[id];
        const auto& other = forwards ? reached_from_distal_[id] : reached_from_proximal_[id];
        const double limit = other.empty() ? volume_mm3_[id] - begin : other.back().volume_mm3;
        const std::optional<double> edge = leading_edge_mm3(id, forwards, limit);
        if (!edge) continue;
        // When the edge passed a place in this step; most begin where the last one ended.
        const auto passed_s = [&](double volume_mm3) {
            const double at_s = time_s_ - std::abs(*edge - volume_mm3) / std::abs(flow);
            return at_s - begin_s > same_time * time_s_ ? at_s : begin_s;
        };
        if (knots.empty()) knots.push_back({begin, passed_s(begin)});
        const double position = forwards ? std::min(*edge, limit) : std::max(*edge, limit);
        if (std::abs(position - knots.back().volume_mm3) <= empty_volume * volume_mm3_[id])
            continue;
        if (forwards != (position > knots.back().volume_mm3)) continue;
        // The flow had stopped or turned meanwhile.
        const double on_s = passed_s(knots.back().volume_mm3);
        if (on_s - knots.back().time_s > same_time * time_s_)
            knots.push_back({knots.back().volume_mm3, on_s});
        const double now_s = position == *edge ? time_s_ : passed_s(position);
        // While the flow is steady the last knot moves along; a change of speed starts a new one.
        if (knots.size() > 1 && knots[knots.size() - 2].volume_mm3 != knots.back().volume_mm3) {
            const auto& a = knots[knots.size() - 2];
            const auto& b = knots.back();
            const double expected = a.time_s + (b.time_s - a.time_s) * (position - a.volume_mm3) /
                                                   (b.volume_mm3 - a.volume_mm3);
            if (std::abs(expected - now_s) <= 1e-12 * now_s) knots.pop_back();
        }
        knots.push_back({position, now_s});
    }
}

FrontStep DrugFront::step(double longest_s) {
    if (!(longest_s >= 0.0 && longest_s < std::numeric_limits<double>::infinity()))
        throw InputError("the step is " + number_text(longest_s) + " s", "injection",
                         "Give a time of 0 s or more");
    FrontStep done;
    done.duration_s = std::min(longest_s, options_.injection_end_s - time_s_);
    Flows flows{flow().volume_flow_mm3_s, flow().inlet_flow_mm3_s};
    std::vector<int> changed;
    double stretch = 1.0;
    if (two_fluids() && !at_rest()) {
        const double event_s = time_to_event(flows.segment_mm3_s, same_share);
        // The change of flows may delay the event a little: go there instead of stopping just
        // before.
        if (event_s <= std::min(done.duration_s, suggested_s_)) stretch = 1.1;
        done.duration_s = std::min({done.duration_s, suggested_s_, event_s});
        flows = predict(done.duration_s);
        changed = touched_;
    }
    mix_at_nodes(flows);
    const double event_s = time_to_event(flows.segment_mm3_s, same_share);
    if (event_s <= stretch * done.duration_s && event_s <= options_.injection_end_s - time_s_ &&
        event_s <= longest_s) {
        done.duration_s = event_s;
        done.event = FrontEvent::node_reached;
    }
    const double begin_s = time_s_;
    const bool ends =
        done.event == FrontEvent::none && done.duration_s == options_.injection_end_s - time_s_;
    time_s_ = ends ? options_.injection_end_s : time_s_ + done.duration_s;
    ++steps_;
    move(flows, done.duration_s, nullptr);
    count(flows, done.duration_s);
    note_arrivals(flows, begin_s);
    if (two_fluids()) {
        std::vector<int> refilled;
        std::ranges::set_union(changed, touched_, std::back_inserter(refilled));
        refill(refilled);
        if (!refilled.empty()) flow_->solve();
    }
    if (ends) {
        end_injection();
        done.event = FrontEvent::injection_ended;
    }
    look_ahead();
    return done;
}

void DrugFront::look_ahead() {
    const Flows flows{flow().volume_flow_mm3_s, flow().inlet_flow_mm3_s};
    mix_at_nodes(flows);
    at_rest_ = std::isinf(
        time_to_event(flows.segment_mm3_s, std::max(same_share, options_.concentration_tolerance)));
}

void DrugFront::end_injection() {
    options_.injection_end_s = std::numeric_limits<double>::infinity();
    conditions_.inlets.erase(conditions_.inlets.begin() + drug_inlet_);
    drug_inlet_ = -1;
    begin_flow();
}

void DrugFront::rejoin(FlowNetwork network, FlowConditions conditions) {
    assert(network.segments.size() == network_.segments.size());
    assert(conditions.inlets.size() == conditions_.inlets.size());
    flow_.reset();  // refers to the network
    network_ = std::move(network);
    conditions_ = std::move(conditions);
    node_share_.assign(static_cast<std::size_t>(network_.node_count), 0.0);
    node_surplus_.assign(static_cast<std::size_t>(network_.node_count), 0.0);
    suggested_s_ = std::numeric_limits<double>::infinity();
    begin_flow();
    look_ahead();
}

// Of the network as it is now, with what fills it.
void DrugFront::begin_flow() {
    flow_ = std::make_unique<NetworkFlow>(network_, conditions_);
    std::vector<int> filled;
    for (std::size_t i = 0; i < slugs_.size(); ++i)
        if (!slugs_[i].empty()) filled.push_back(static_cast<int>(i));
    refill(filled);
    flow_->solve();
}

FrontStep DrugFront::step_towards(double time_s) {
    const double left_s = time_s - time_s_;
    const FrontStep done = step(left_s);
    if (done.duration_s == left_s) time_s_ = time_s;
    return done;
}

void DrugFront::advance_to(double time_s) {
    while (time_s_ < time_s) step_towards(time_s);
}

double DrugFront::drug_mm3(int segment) const {
    double drug = 0.0;
    for (const Slug& slug : slugs_[segment]) drug += slug.volume_mm3 * slug.share;
    return drug;
}

double DrugFront::drug_up_to_mm3(int segment, double volume_mm3) const {
    double drug = 0.0;
    for (const Slug& slug : slugs_[segment]) {
        drug += std::clamp(volume_mm3, 0.0, slug.volume_mm3) * slug.share;
        volume_mm3 -= slug.volume_mm3;
    }
    return drug;
}

double DrugFront::filled_fraction(int segment) const {
    return volume_mm3_[segment] > 0.0 ? drug_mm3(segment) / volume_mm3_[segment] : 0.0;
}

double DrugFront::filled_length_mm(int segment) const {
    const auto& up = reached_from_proximal_[segment];
    const auto& down = reached_from_distal_[segment];
    const double length = length_mm(network_, segment);
    double filled = 0.0;
    if (!up.empty()) filled += arclength_at_mm(network_, segment, up.back().volume_mm3);
    if (!down.empty())
        filled += length - arclength_at_mm(network_, segment, down.back().volume_mm3);
    return std::min(filled, length);
}

DrugBalance DrugFront::balance() const {
    DrugBalance balance{injected_mm3_, 0.0, left_mm3_, bled_mm3_};
    for (std::size_t i = 0; i < slugs_.size(); ++i)
        balance.inside_mm3 += drug_mm3(static_cast<int>(i));
    return balance;
}

ArrivalTimes DrugFront::arrival_times() const {
    ArrivalTimes times(network_);
    for (std::size_t i = 0; i < slugs_.size(); ++i) {
        const int id = static_cast<int>(i);
        times.set_from_proximal(id, reached_from_proximal_[i]);
        std::vector<ArrivalTimes::Knot> ascending(reached_from_distal_[i].rbegin(),
                                                  reached_from_distal_[i].rend());
        times.set_from_distal(id, std::move(ascending));
    }
    return times;
}

}  // namespace hepatica
