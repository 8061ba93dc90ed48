// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/stepper/quality_dial.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/error.h"

namespace hepatica {
std::vector<std::size_t> pareto_front(std::span<const double> cost, std::span<const double> error) {
    std::vector<std::size_t> order(cost.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        return cost[a] != cost[b] ? cost[a] < cost[b] : error[a] < error[b];
    });
    std::vector<std::size_t> front;
    for (const std::size_t i : order)
        if (front.empty() || error[i] < error[front.back()]) front.push_back(i);
    return front;
}

QualityDial::QualityDial(std::vector<QualityPoint> measured) {
    std::vector<double> cost, error;
    for (const QualityPoint& point : measured) {
        if (!std::isfinite(point.frame_ms) || !(point.frame_ms > 0.0) ||
            !std::isfinite(point.error_relative) || point.error_relative < 0.0)
            throw InputError("a measurement is not finite or below 0", "the dial", "Measure again");
        cost.push_back(point.frame_ms);
        error.push_back(point.error_relative);
    }
    for (const std::size_t i : pareto_front(cost, error)) front_.push_back(measured[i]);
    if (front_.empty())
        throw InputError("there is no measurement", "the dial", "Measure at least one setting");
}

std::size_t QualityDial::index_at(double quality) const {
    constexpr double rounding = 1e-9;
    std::size_t best = 0;
    while (best + 1 < front_.size() && quality_of(best + 1) <= quality + rounding) ++best;
    return best;
}

double QualityDial::quality_of(std::size_t index) const {
    // The cheapest setting has quality 0 even where it is the only one.
    if (index == 0) return 0.0;
    const double low = std::log(front_.front().frame_ms), high = std::log(front_.back().frame_ms);
    return (std::log(front_[index].frame_ms) - low) / (high - low);
}

}  // namespace hepatica
