// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/label_places.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hepatica {
namespace {

constexpr double label_gap = 2.0;
constexpr double rounding = 1e-9;  // labels that are exactly a gap apart do not meet

bool meet(const LabelBox& a, const LabelBox& b) {
    const double gap = label_gap - rounding;
    return a.left < b.left + b.width + gap && b.left < a.left + a.width + gap &&
           a.top < b.top + b.height + gap && b.top < a.top + a.height + gap;
}

}  // namespace

bool LabelPlaces::is_free(const LabelBox& box) const {
    return box.left >= room_.left && box.left + box.width <= room_.left + room_.width &&
           box.top >= room_.top && box.top + box.height <= room_.top + room_.height &&
           std::ranges::none_of(placed_, [&](const LabelBox& other) { return meet(box, other); });
}

// It is in line with the wanted place or beside a label, in each of x and y, as every nearest free
// place is.
std::optional<LabelBox> LabelPlaces::beside_others(const LabelBox& wanted) const {
    std::vector<double> lefts{wanted.left}, tops{wanted.top};
    for (const LabelBox& other : placed_) {
        lefts.push_back(other.left - wanted.width - label_gap);
        lefts.push_back(other.left + other.width + label_gap);
        tops.push_back(other.top - wanted.height - label_gap);
        tops.push_back(other.top + other.height + label_gap);
    }
    std::optional<LabelBox> nearest;
    double least = std::numeric_limits<double>::infinity();
    for (const double left : lefts)
        for (const double top : tops) {
            const LabelBox box{left, top, wanted.width, wanted.height};
            const double distance = std::hypot(left - wanted.left, top - wanted.top);
            if (distance >= least || !is_free(box)) continue;
            least = distance;
            nearest = box;
        }
    return nearest;
}

std::optional<PlacedLabel> LabelPlaces::place(const LabelBox& wanted) {
    if (wanted.width > room_.width || wanted.height > room_.height) return std::nullopt;
    LabelBox box = wanted;
    box.left = std::clamp(box.left, room_.left, room_.left + room_.width - box.width);
    box.top = std::clamp(box.top, room_.top, room_.top + room_.height - box.height);
    const bool evades =
        std::ranges::any_of(placed_, [&](const LabelBox& other) { return meet(box, other); });
    if (evades) {
        const std::optional<LabelBox> free = beside_others(box);
        if (!free) return std::nullopt;
        box = *free;
    }
    placed_.push_back(box);
    return PlacedLabel{box, evades};
}

}  // namespace hepatica
