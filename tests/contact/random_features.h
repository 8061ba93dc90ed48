// SPDX-License-Identifier: GPL-3.0-or-later
// Points, segments and triangles as tests of geometry want them: of all sizes, and now and then
// flat, without length, parallel or sharing a corner.
#pragma once

#include <random>

#include "core/contact/closest_points.h"

namespace hepatica::test {

class RandomFeatures {
  public:
    explicit RandomFeatures(unsigned seed) : random_(seed) {}

    double in(double low, double high) {
        return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1.0p-53;
    }
    int whole(int below) { return static_cast<int>(random_() % static_cast<unsigned>(below)); }
    Vec3 point(double size = 1.0) { return {in(-size, size), in(-size, size), in(-size, size)}; }
    Segment segment(double size = 1.0) {
        Segment s{point(size), point(size)};
        if (whole(10) == 0) s[1] = s[0];
        return s;
    }
    Triangle triangle(double size = 1.0) {
        Triangle t{point(size), point(size), point(size)};
        if (whole(10) == 0) t[2] = t[0] + in(-0.5, 1.5) * (t[1] - t[0]);
        if (whole(20) == 0) t[1] = t[0];
        return t;
    }

  private:
    std::mt19937_64 random_;
};

}  // namespace hepatica::test
