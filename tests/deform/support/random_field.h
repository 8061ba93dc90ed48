// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors to shake a body with, the same on every machine.
#pragma once

#include <random>
#include <span>
#include <vector>

#include "core/base/vector.h"

namespace hepatica::test {

// Coordinates spread evenly over [-size, size].
inline std::vector<Vec3> random_field(std::size_t count, double size, unsigned seed) {
    std::mt19937_64 random(seed);
    std::vector<Vec3> field(count);
    for (Vec3& x : field)
        for (int i = 0; i < 3; ++i)
            x[i] = size * (static_cast<double>(random() >> 11) * 0x1.0p-52 - 1.0);
    return field;
}

inline std::vector<Vec3> copy_of(std::span<const Vec3> field) {
    return {field.begin(), field.end()};
}

}  // namespace hepatica::test
