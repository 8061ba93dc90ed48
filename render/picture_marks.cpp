// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/picture_marks.h"

#include <algorithm>
#include <cmath>

#include "render/flat_distance.h"

namespace hepatica {
namespace {

using Point = std::array<double, 2>;

// Blends the colour into each pixel of the box by how much of the pixel lies within `half_width` of
// the mark. `distance` gives the distance of a pixel's centre from the mark.
template <class Distance>
void paint(Picture& picture, Point low, Point high, double half_width, const Colour& colour,
           const Distance& distance) {
    const double reach = half_width + 1.0;
    const auto clamped = [](double x, int size) {
        return static_cast<int>(std::clamp(x, 0.0, static_cast<double>(size)));
    };
    const int right = clamped(high[0] + reach, picture.width);
    const int bottom = clamped(high[1] + reach, picture.height);
    for (int y = clamped(low[1] - reach, picture.height); y < bottom; ++y)
        for (int x = clamped(low[0] - reach, picture.width); x < right; ++x) {
            const double cover =
                std::clamp(half_width + 0.5 - distance({x + 0.5, y + 0.5}), 0.0, 1.0);
            std::uint8_t* pixel =
                &picture.rgb[3 * (static_cast<std::size_t>(y) * picture.width + x)];
            for (int c = 0; c < 3; ++c)
                pixel[c] = static_cast<std::uint8_t>(
                    std::lround((1.0 - cover) * pixel[c] + cover * 255.0 * colour[c]));
        }
}

}  // namespace

void draw_line(Picture& picture, std::span<const Point> points, double width,
               const Colour& colour) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Point& a = points[i - 1];
        const Point& b = points[i];
        paint(picture, {std::min(a[0], b[0]), std::min(a[1], b[1])},
              {std::max(a[0], b[0]), std::max(a[1], b[1])}, 0.5 * width, colour,
              [&](const Point& p) { return distance_to_stretch(p, a, b); });
    }
}

void draw_circle(Picture& picture, const Point& centre, double radius, double width,
                 const Colour& colour) {
    paint(picture, {centre[0] - radius, centre[1] - radius},
          {centre[0] + radius, centre[1] + radius}, 0.5 * width, colour, [&](const Point& p) {
              return std::abs(std::hypot(p[0] - centre[0], p[1] - centre[1]) - radius);
          });
}

}  // namespace hepatica
