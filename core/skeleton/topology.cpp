// SPDX-License-Identifier: GPL-3.0-or-later
// Components by runs and union-find, the Euler number by a table of the 2 x 2 x 2 neighbourhoods.
#include "core/skeleton/topology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/base/disjoint_sets.h"
#include "core/base/parallel.h"

namespace hepatica {

namespace {

// The object's bounding box with one layer of background around it.
struct BoxedMask {
    Index3 dims{0, 0, 0};
    std::vector<std::uint8_t> voxels;

    const std::uint8_t* row(int y, int z) const {
        return voxels.data() +
               dims[0] * (static_cast<std::size_t>(y) + static_cast<std::size_t>(dims[1]) * z);
    }
};

BoxedMask boxed(const Mask& mask) {
    Index3 low = mask.grid.dims;
    Index3 high{-1, -1, -1};
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        if (mask.voxels[i] == 0) continue;
        const Index3 p = mask.grid.index_of(i);
        for (int a = 0; a < 3; ++a) {
            low[a] = std::min(low[a], p[a]);
            high[a] = std::max(high[a], p[a]);
        }
    }
    BoxedMask box;
    if (high[0] < 0) return box;
    for (int a = 0; a < 3; ++a) box.dims[a] = high[a] - low[a] + 3;
    box.voxels.assign(
        static_cast<std::size_t>(box.dims[0]) * box.dims[1] * static_cast<std::size_t>(box.dims[2]),
        0);
    for (int z = low[2]; z <= high[2]; ++z)
        for (int y = low[1]; y <= high[1]; ++y) {
            auto* to = const_cast<std::uint8_t*>(box.row(y - low[1] + 1, z - low[2] + 1)) + 1;
            for (int x = low[0]; x <= high[0]; ++x) *to++ = mask.at(x, y, z) != 0;
        }
    return box;
}

// Maximal stretch [begin, end) of equal voxels in a row.
struct Run {
    int begin, end;
    std::uint32_t set;
};

// Unites the runs of two rows that overlap after widening by `reach` voxels on both sides.
void unite_rows(const std::vector<Run>& a, const std::vector<Run>& b, int reach,
                DisjointSets& sets) {
    std::size_t i = 0, j = 0;
    while (i < a.size() && j < b.size()) {
        if (a[i].begin < b[j].end + reach && b[j].begin < a[i].end + reach)
            sets.unite(a[i].set, b[j].set);
        if (a[i].end < b[j].end)
            ++i;
        else
            ++j;
    }
}

// Number of components of the voxels equal to `value`, by the 26 neighbours or by the 6 face
// neighbours.
long long count_components(const BoxedMask& box, std::uint8_t value, bool by_26) {
    DisjointSets sets;
    const auto [nx, ny, nz] = box.dims;
    std::vector<std::vector<Run>> below(ny), here(ny);
    for (int z = 0; z < nz; ++z) {
        for (int y = 0; y < ny; ++y) {
            here[y].clear();
            const std::uint8_t* row = box.row(y, z);
            for (int x = 0; x < nx;) {
                const int begin = x;
                while (x < nx && row[x] == row[begin]) ++x;
                if (row[begin] == value) here[y].push_back({begin, x, sets.add()});
            }
            const int reach = by_26 ? 1 : 0;
            if (y > 0) unite_rows(here[y], here[y - 1], reach, sets);
            if (z == 0) continue;
            unite_rows(here[y], below[y], reach, sets);
            if (!by_26) continue;
            if (y > 0) unite_rows(here[y], below[y - 1], reach, sets);
            if (y + 1 < ny) unite_rows(here[y], below[y + 1], reach, sets);
        }
        std::swap(here, below);
    }
    return static_cast<long long>(sets.count());
}

// Contribution to the Euler number of one corner of the voxel grid, with the edges, faces and cube
// that start there, for each of the 256 states of the eight voxels around it (bit dx + 2 dy + 4
// dz).
std::array<int, 256> euler_table() {
    const auto any = [](int state, int need) {
        for (int bit = 0; bit < 8; ++bit)
            if ((state >> bit & 1) != 0 && (bit & need) == need) return 1;
        return 0;
    };
    std::array<int, 256> table{};
    for (int state = 0; state < 256; ++state)
        table[state] = any(state, 0) - any(state, 1) - any(state, 2) - any(state, 4) +
                       any(state, 3) + any(state, 5) + any(state, 6) - any(state, 7);
    return table;
}

long long euler_number(const BoxedMask& box) {
    const std::array<int, 256> table = euler_table();
    const auto [nx, ny, nz] = box.dims;
    const auto layers = static_cast<std::size_t>(nz - 1);
    return std::llround(
        parallel_sum(layers, 8, [&, nx = nx, ny = ny](std::size_t b, std::size_t e) {
            long long sum = 0;
            for (auto z = static_cast<int>(b) + 1; z <= static_cast<int>(e); ++z)
                for (int y = 1; y < ny; ++y) {
                    const std::uint8_t* rows[4] = {box.row(y - 1, z - 1), box.row(y, z - 1),
                                                   box.row(y - 1, z), box.row(y, z)};
                    for (int x = 1; x < nx; ++x) {
                        int state = 0;
                        for (int r = 0; r < 4; ++r)
                            state |= (rows[r][x - 1] | rows[r][x] << 1) << (2 * r);
                        sum += table[state];
                    }
                }
            return static_cast<double>(sum);
        }));
}

}  // namespace

Betti betti_numbers(const Mask& mask) {
    const BoxedMask box = boxed(mask);
    if (box.voxels.empty()) return {};
    Betti betti;
    betti.components = count_components(box, 1, true);
    betti.cavities = count_components(box, 0, false) - 1;
    betti.tunnels = betti.components + betti.cavities - euler_number(box);
    return betti;
}

}  // namespace hepatica
