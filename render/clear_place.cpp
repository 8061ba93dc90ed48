// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/clear_place.h"

#include <algorithm>
#include <cmath>

#include "render/flat_distance.h"

namespace hepatica {
namespace {

// By the part of the line that lies within each pair of parallel edges (Liang and Barsky 1984).
bool line_meets(const PictureBox& box, const ThickStretch& stretch) {
    const std::array<double, 2> low{box.left, box.bottom}, high{box.right, box.top};
    double begin = 0.0, end = 1.0;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double from = stretch.from[axis], way = stretch.to[axis] - from;
        if (way == 0.0) {
            if (from < low[axis] || from > high[axis]) return false;
            continue;
        }
        const double one = (low[axis] - from) / way, other = (high[axis] - from) / way;
        begin = std::max(begin, std::min(one, other));
        end = std::min(end, std::max(one, other));
    }
    return begin <= end;
}

double distance_to_point(const PictureBox& box, const std::array<double, 2>& point) {
    return std::hypot(std::max({box.left - point[0], 0.0, point[0] - box.right}),
                      std::max({box.bottom - point[1], 0.0, point[1] - box.top}));
}

}  // namespace

// Where they do not meet, a corner of the one or an end of the other is nearest.
double distance_between(const PictureBox& box, const ThickStretch& stretch) {
    if (line_meets(box, stretch)) return 0.0;
    double least =
        std::min(distance_to_point(box, stretch.from), distance_to_point(box, stretch.to));
    for (const double x : {box.left, box.right})
        for (const double y : {box.bottom, box.top})
            least = std::min(least, distance_to_stretch({x, y}, stretch.from, stretch.to));
    return least;
}

ThickStretch covering(const PictureBox& box) {
    const double middle = 0.5 * (box.bottom + box.top);
    return {{box.left, middle}, {box.right, middle}, 0.5 * (box.top - box.bottom)};
}

bool is_clear_of(const PictureBox& box, std::span<const ThickStretch> stretches, double margin) {
    return std::ranges::all_of(stretches, [&](const ThickStretch& stretch) {
        return distance_between(box, stretch) >= stretch.radius + margin;
    });
}

}  // namespace hepatica
