// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers for the phantom that are the same on every platform, unlike the distributions of
// the standard library.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "core/base/vector.h"

namespace hepatica {

// A stream of numbers from one seed.
class PhantomRandom {
  public:
    explicit PhantomRandom(std::uint64_t seed) : engine_(seed) {}

    // In [0, 1), with 53 random bits.
    double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    // Uniform in an axis-aligned box.
    Vec3 point(const Vec3& low, const Vec3& high) {
        const double x = uniform(low[0], high[0]);
        const double y = uniform(low[1], high[1]);
        const double z = uniform(low[2], high[2]);
        return {x, y, z};
    }

  private:
    std::mt19937_64 engine_;
};

// Scrambles a counter (finaliser of SplitMix64), so that a voxel's noise depends only on its index,
// whichever thread draws it.
inline std::uint64_t scrambled(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15ULL;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
}

// A standard normal deviate that belongs to `counter` (Box and Muller 1958).
inline float normal_deviate(std::uint64_t counter) {
    const std::uint64_t bits = scrambled(counter);
    const float u = (static_cast<float>(bits >> 40) + 0.5f) * 0x1p-24f;
    const float angle =
        static_cast<float>(bits & 0xffffff) * (2.0f * std::numbers::pi_v<float> * 0x1p-24f);
    return std::sqrt(-2.0f * std::log(u)) * std::cos(angle);
}

}  // namespace hepatica
