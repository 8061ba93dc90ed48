// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/label_places.h"

#include <algorithm>
#include <cmath>

namespace hepatica {
namespace {

constexpr double label_gap = 2.0;

bool meet(const LabelBox& a, const LabelBox& b) {
    return a.left < b.left + b.width && b.left < a.left + a.width &&
           a.top < b.top + b.height + label_gap && b.top < a.top + a.height + label_gap;
}

}  // namespace

bool LabelPlaces::is_free(const LabelBox& box) const {
    return box.top >= least_ && box.top + box.height <= most_ &&
           std::ranges::none_of(placed_, [&](const LabelBox& other) { return meet(box, other); });
}

// Just above or just below one that is there, as every nearest free place is.
double LabelPlaces::place(const LabelBox& box) {
    const auto shifted = [&](double by) {
        return LabelBox{box.left, box.top + by, box.width, box.height};
    };
    std::vector<double> shifts;
    for (const LabelBox& other : placed_) {
        shifts.push_back(other.top - box.height - label_gap - box.top);
        shifts.push_back(other.top + other.height + label_gap - box.top);
    }
    std::ranges::stable_sort(shifts, {}, [](double by) { return std::abs(by); });
    const bool stands =
        std::ranges::none_of(placed_, [&](const LabelBox& other) { return meet(box, other); });
    double by = 0.0;
    if (!stands)
        if (const auto free =
                std::ranges::find_if(shifts, [&](double shift) { return is_free(shifted(shift)); });
            free != shifts.end())
            by = *free;
    placed_.push_back(shifted(by));
    return by;
}

}  // namespace hepatica
