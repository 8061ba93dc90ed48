// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/dose_account.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/base/error.h"

namespace hepatica {

namespace {

constexpr double samples = 500.0;
constexpr double least_step_s = 1e-9;  // that inject() takes

Dose sum(const Dose& a, const Dose& b) {
    return {a.injected_g + b.injected_g, a.delivered_g + b.delivered_g, a.target_g + b.target_g,
            a.reflux_g + b.reflux_g};
}

double between(double a, double b, double share) {
    return a + share * (b - a);
}

// Per outlet: 1 where the segment that ends there ends inside the region.
std::vector<char> outlets_in(const VesselTree& tree, const std::vector<int>& outlets,
                             const TargetRegion& region) {
    std::vector<char> node(tree.nodes.size(), 0);
    for (std::size_t s = 0; s < tree.segments.size(); ++s)
        node[tree.segments[s].distal_node] = region.contains_end_of(static_cast<int>(s));
    std::vector<char> inside;
    for (const int outlet : outlets) inside.push_back(node[outlet]);
    return inside;
}

// What is in the target and what was delivered are sums of the same masses in another order, which
// round differently: where all went into the target, the difference is none, of neither sign, and
// no more went there than was delivered. Likewise for what ran back.
Dose without_rounding(Dose dose) {
    constexpr double rounding = 1e-12;
    if (dose.target_g >= dose.delivered_g * (1.0 - rounding)) dose.target_g = dose.delivered_g;
    if (dose.reflux_g <= dose.delivered_g * rounding) dose.reflux_g = 0.0;
    return dose;
}

double mass_in(const std::vector<double>& outlet_g, const std::vector<char>& inside) {
    double mass = 0.0;
    for (std::size_t o = 0; o < outlet_g.size(); ++o)
        if (inside[o] != 0) mass += outlet_g[o];
    return mass;
}

}  // namespace

DoseCurve::DoseCurve(const VesselTree& tree, const InjectionOptions& options, double end_s,
                     const std::optional<TargetRegion>& target,
                     std::function<void(JobEvent)> observer) {
    job_.observe(std::move(observer));
    InjectionOptions run = options;
    run.until_s = end_s;
    run.step_s = std::max(end_s / samples, least_step_s);
    thread_ = std::jthread([this, &tree, run, target] {
        std::exception_ptr error;
        try {
            compute(tree, run, target);
        } catch (...) {
            error = std::current_exception();
        }
        const std::scoped_lock lock(mutex_);
        ended_ = true;
        error_ = error;
        more_.notify_all();
    });
}

DoseCurve::~DoseCurve() {
    job_.cancel();
}

void DoseCurve::compute(const VesselTree& tree, const InjectionOptions& run,
                        const std::optional<TargetRegion>& target) {
    std::vector<char> beyond_tip, in_target;
    inject(tree, run, job_, [&](const InjectionResult& result) {
        if (result.series.size() == 1) {
            beyond_tip = outlets_in(tree, result.outlet_nodes, TargetRegion(tree, *run.tip));
            in_target = target ? outlets_in(tree, result.outlet_nodes, *target)
                               : std::vector<char>(result.outlet_nodes.size(), 0);
        }
        const InjectionSample& sample = result.series.back();
        const Dose dose = without_rounding(
            {sample.injected_g, sample.delivered_g, mass_in(sample.outlet_mass_g, in_target),
             sample.delivered_g - mass_in(sample.outlet_mass_g, beyond_tip)});
        const std::scoped_lock lock(mutex_);
        time_s_.push_back(sample.time_s);
        dose_.push_back(dose);
        more_.notify_all();
    });
}

Dose DoseCurve::at(double time_s, const std::stop_token& stop) const {
    std::unique_lock lock(mutex_);
    const bool known = more_.wait(
        lock, stop, [&] { return ended_ || (!time_s_.empty() && time_s_.back() > time_s); });
    if (!known) throw Cancelled();
    if (error_ && (time_s_.empty() || time_s_.back() <= time_s)) std::rethrow_exception(error_);
    const auto after = std::ranges::upper_bound(time_s_, time_s);
    if (after == time_s_.begin()) return dose_.front();
    if (after == time_s_.end()) return dose_.back();
    const std::ptrdiff_t i = after - time_s_.begin();
    const double share = (time_s - time_s_[i - 1]) / (time_s_[i] - time_s_[i - 1]);
    const Dose &a = dose_[i - 1], &b = dose_[i];
    return without_rounding(
        {between(a.injected_g, b.injected_g, share), between(a.delivered_g, b.delivered_g, share),
         between(a.target_g, b.target_g, share), between(a.reflux_g, b.reflux_g, share)});
}

void DoseAccount::see(const DrugView& drug, const std::stop_token& stop) {
    const auto undone = [&drug](const Part& part) {
        const bool replaced = drug.injection != nullptr && part.injection != drug.injection;
        return part.number > drug.injections || (part.number == drug.injections && replaced);
    };
    while (!parts_.empty() && undone(parts_.back())) parts_.pop_back();
    const bool shown = !parts_.empty() && parts_.back().injection == drug.injection;
    if (!shown && !parts_.empty()) parts_.back().curve.reset();
    if (!drug.injection) return;
    if (!shown) parts_.push_back({drug.injections, drug.injection, {}, {}});
    Part& part = parts_.back();
    if (!part.curve)
        part.curve = std::make_unique<const DoseCurve>(tree_, *drug.injection, drug.end_s, target_);
    part.dose = part.curve->at(drug.time_s, stop);
}

Dose DoseAccount::total() const {
    Dose all;
    for (const Part& part : parts_) all = sum(all, part.dose);
    return all;
}

}  // namespace hepatica
