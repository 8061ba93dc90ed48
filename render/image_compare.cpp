// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/image_compare.h"

#include <algorithm>
#include <cstdlib>

namespace hepatica {
namespace {

const std::uint8_t* pixel(const Picture& picture, int x, int y) {
    return picture.rgb.data() +
           3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                static_cast<std::size_t>(x));
}

int distance(const std::uint8_t* a, const std::uint8_t* b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

bool found_nearby(const Picture& picture, int x, int y, const std::uint8_t* wanted, int tolerance) {
    for (int v = std::max(0, y - 1); v <= std::min(picture.height - 1, y + 1); ++v) {
        for (int u = std::max(0, x - 1); u <= std::min(picture.width - 1, x + 1); ++u) {
            if (distance(pixel(picture, u, v), wanted) <= tolerance) return true;
        }
    }
    return false;
}

}  // namespace

PictureDifference compare_pictures(const Picture& a, const Picture& b, int tolerance) {
    PictureDifference difference;
    difference.same_size = a.width == b.width && a.height == b.height;
    if (!difference.same_size || a.rgb.empty()) return difference;
    double sum = 0.0;
    std::size_t different = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const std::uint8_t* in_a = pixel(a, x, y);
            const std::uint8_t* in_b = pixel(b, x, y);
            for (int c = 0; c < 3; ++c) sum += std::abs(in_a[c] - in_b[c]);
            if (distance(in_a, in_b) <= tolerance) continue;
            if (!found_nearby(b, x, y, in_a, tolerance) ||
                !found_nearby(a, x, y, in_b, tolerance)) {
                ++different;
            }
        }
    }
    const double pixels = static_cast<double>(a.rgb.size()) / 3.0;
    difference.mean = sum / (3.0 * pixels);
    difference.different_share = static_cast<double>(different) / pixels;
    return difference;
}

}  // namespace hepatica
