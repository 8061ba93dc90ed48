// SPDX-License-Identifier: GPL-3.0-or-later
// Connected components inside a 27-bit neighbourhood by bitwise dilation.
#include "core/skeleton/simple_point.h"

namespace hepatica {

namespace {

// Bits of the neighbours whose offset satisfies a predicate.
template <class Predicate>
constexpr std::uint32_t bits_where(Predicate predicate) {
    std::uint32_t bits = 0;
    for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
                if (predicate(dx, dy, dz)) bits |= 1u << neighbour_bit(dx, dy, dz);
    return bits;
}

constexpr int absolute(int v) {
    return v < 0 ? -v : v;
}

constexpr std::uint32_t not_low_x = bits_where([](int x, int, int) { return x > -1; });
constexpr std::uint32_t not_high_x = bits_where([](int x, int, int) { return x < 1; });
constexpr std::uint32_t not_low_y = bits_where([](int, int y, int) { return y > -1; });
constexpr std::uint32_t not_high_y = bits_where([](int, int y, int) { return y < 1; });
constexpr std::uint32_t everything = (1u << 27) - 1;
constexpr std::uint32_t faces =
    bits_where([](int x, int y, int z) { return absolute(x) + absolute(y) + absolute(z) == 1; });
constexpr std::uint32_t nearest_18 = bits_where([](int x, int y, int z) {
    const int distance = absolute(x) + absolute(y) + absolute(z);
    return distance == 1 || distance == 2;
});

// The set shifted by one voxel in both directions along an axis.
constexpr std::uint32_t spread_x(std::uint32_t set) {
    return (set & not_high_x) << 1 | (set & not_low_x) >> 1;
}
constexpr std::uint32_t spread_y(std::uint32_t set) {
    return (set & not_high_y) << 3 | (set & not_low_y) >> 3;
}
constexpr std::uint32_t spread_z(std::uint32_t set) {
    return (set << 9 & everything) | set >> 9;
}

constexpr std::uint32_t grow_26(std::uint32_t set) {
    set |= spread_x(set);
    set |= spread_y(set);
    return set | spread_z(set);
}
constexpr std::uint32_t grow_6(std::uint32_t set) {
    return set | spread_x(set) | spread_y(set) | spread_z(set);
}

constexpr std::uint32_t lowest_bit(std::uint32_t set) {
    return set & (0u - set);
}

}  // namespace

bool is_simple(std::uint32_t neighbourhood) {
    const std::uint32_t background_faces = ~neighbourhood & faces;
    if (background_faces == 0) return false;
    const std::uint32_t background = ~neighbourhood & nearest_18;
    std::uint32_t reached = lowest_bit(background_faces);
    for (std::uint32_t before = 0; before != reached;) {
        before = reached;
        reached = grow_6(reached) & background;
    }
    if ((background_faces & ~reached) != 0) return false;

    const std::uint32_t object = neighbourhood & ~centre_bit;
    if (object == 0) return false;
    reached = lowest_bit(object);
    for (std::uint32_t before = 0; before != reached;) {
        before = reached;
        reached = grow_26(reached) & object;
    }
    return reached == object;
}

}  // namespace hepatica
