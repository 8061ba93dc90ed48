// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/voxel_picture.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace hepatica {

namespace {

using Rgb = std::array<std::uint8_t, 3>;
struct Point {
    double x, y;
};

class Canvas {
  public:
    Canvas(const Index3& low, const Index3& high, int pixels) : pixels_(pixels) {
        const Index3 end{high[0] + 1, high[1] + 1, high[2] + 1};
        Point smallest{1e9, 1e9}, largest{-1e9, -1e9};
        for (int corner = 0; corner < 8; ++corner) {
            const Point p = projected((corner & 1 ? end : low)[0], (corner & 2 ? end : low)[1],
                                      (corner & 4 ? end : low)[2]);
            smallest = {std::min(smallest.x, p.x), std::min(smallest.y, p.y)};
            largest = {std::max(largest.x, p.x), std::max(largest.y, p.y)};
        }
        shift_ = {margin - smallest.x, margin - smallest.y};
        picture.width = static_cast<int>(largest.x - smallest.x + 2 * margin) + 1;
        picture.height = static_cast<int>(largest.y - smallest.y + 2 * margin) + 1;
        picture.rgb.assign(3 * static_cast<std::size_t>(picture.width) * picture.height, 255);
    }

    // Draws the three faces towards the viewer: +x, +y and +z.
    void cube(const Index3& v, const Rgb& colour) {
        const double x = v[0], y = v[1], z = v[2];
        const Vec3 far(x + 1, y + 1, z + 1);
        face({Vec3(x + 1, y, z), Vec3(x + 1, y + 1, z), far, Vec3(x + 1, y, z + 1)}, colour, 0.62);
        face({Vec3(x, y + 1, z), Vec3(x + 1, y + 1, z), far, Vec3(x, y + 1, z + 1)}, colour, 0.8);
        face({Vec3(x, y, z + 1), Vec3(x + 1, y, z + 1), far, Vec3(x, y + 1, z + 1)}, colour, 1.0);
    }

    Picture picture;

  private:
    static constexpr double margin = 8.0;

    Point projected(double x, double y, double z) const {
        constexpr double run = 0.866, rise = 0.5;
        return {pixels_ * run * (x - y) + shift_.x, pixels_ * (rise * (x + y) - z) + shift_.y};
    }

    void face(const std::array<Vec3, 4>& corners, const Rgb& colour, double light) {
        std::array<Point, 4> p{};
        for (int i = 0; i < 4; ++i) p[i] = projected(corners[i][0], corners[i][1], corners[i][2]);
        const auto [left, right] = std::ranges::minmax(p, {}, &Point::x);
        const auto [top, bottom] = std::ranges::minmax(p, {}, &Point::y);
        for (int y = static_cast<int>(top.y); y <= static_cast<int>(bottom.y) + 1; ++y)
            for (int x = static_cast<int>(left.x); x <= static_cast<int>(right.x) + 1; ++x)
                if (const double depth = inside(p, x + 0.5, y + 0.5); depth > 0.0)
                    set(x, y, colour, depth < 1.0 ? 0.45 * light : light);
    }

    // Distance in pixels from a point inside a convex quadrilateral to its nearest edge; not
    // positive outside.
    static double inside(const std::array<Point, 4>& p, double x, double y) {
        double least = 1e9, sign = 0.0;
        for (int i = 0; i < 4; ++i) {
            const Point& a = p[i];
            const Point& b = p[(i + 1) % 4];
            const double length = std::hypot(b.x - a.x, b.y - a.y);
            const double side = ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) / length;
            if (sign == 0.0) sign = side > 0.0 ? 1.0 : -1.0;
            least = std::min(least, side * sign);
        }
        return least;
    }

    void set(int x, int y, const Rgb& colour, double light) {
        if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return;
        const std::size_t at = 3 * (static_cast<std::size_t>(y) * picture.width + x);
        for (int c = 0; c < 3; ++c)
            picture.rgb[at + c] = static_cast<std::uint8_t>(std::lround(light * colour[c]));
    }

    int pixels_;
    Point shift_{0.0, 0.0};
};

}  // namespace

Picture draw_voxels(const std::vector<VoxelGroup>& groups, const Index3& low, const Index3& high,
                    int pixels) {
    // Sorted from back to front; the viewer looks along (-1, -1, -1).
    std::map<std::tuple<int, int, int, int>, std::pair<Index3, Rgb>> sorted;
    for (const VoxelGroup& group : groups)
        for (const Index3& v : group.voxels) {
            bool in_box = true;
            for (int a = 0; a < 3; ++a) in_box = in_box && v[a] >= low[a] && v[a] <= high[a];
            if (in_box) sorted[{v[0] + v[1] + v[2], v[2], v[1], v[0]}] = {v, group.colour};
        }
    Canvas canvas(low, high, pixels);
    for (const auto& [order, voxel] : sorted) canvas.cube(voxel.first, voxel.second);
    return std::move(canvas.picture);
}

}  // namespace hepatica
