// SPDX-License-Identifier: GPL-3.0-or-later
// Watershed by flooding of the depth (distance transform), O(n log n) in the number of voxels, then
// a maximum spanning tree over the necks.
#include "core/segmentation/organ_lobes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/image/mask.h"
#include "core/image/morphology.h"

namespace hepatica {

namespace {

constexpr double least_rise_mm = 2.0;
constexpr double widest_neck = 0.9;  // as a share of the shallower basin's depth
constexpr float bottomless_mm = 1000.0f;
constexpr std::size_t voxels_a_check = 65536;

struct Neck {
    std::size_t a = 0, b = 0;
    double depth_mm = 0.0;
};

// Grows basins from the deepest voxel to the surface (flooding after Vincent and Soille, upside
// down) and merges two basins whose neck is shallow or nearly as wide as they are.
class Flood {
  public:
    explicit Flood(const FloatVolume& depth) : depth_(depth), labels_(depth.grid) {}

    void add(std::size_t voxel) {
        const auto depth_mm = static_cast<double>(depth_.voxels[voxel]);
        std::array<std::size_t, 6> around{};
        const std::size_t count = basins_around(voxel, around);
        if (count == 0) {
            peak_mm_.push_back(depth_mm);
            labels_.voxels[voxel] = basins_.add() + 1;
            return;
        }
        std::size_t deepest = around[0];
        for (std::size_t k = 1; k < count; ++k)
            if (peak_mm_[around[k]] > peak_mm_[deepest]) deepest = around[k];
        for (std::size_t k = 0; k < count; ++k) meet(around[k], deepest, depth_mm);
        labels_.voxels[voxel] = static_cast<std::uint32_t>(root_of(deepest) + 1);
    }

    // The remaining basins, numbered by their first voxel. Moves the labels out: call it once, at
    // the end.
    Lobes result();
    // The necks between the lobes, deepest first. Only after result(), which numbers the lobes.
    std::vector<Neck> necks() {
        std::vector<Neck> between;
        for (const Neck& neck : necks_) {
            const int a = number_[root_of(neck.a)], b = number_[root_of(neck.b)];
            if (a != b)
                between.push_back(
                    {static_cast<std::size_t>(a), static_cast<std::size_t>(b), neck.depth_mm});
        }
        std::stable_sort(between.begin(), between.end(), [](const Neck& first, const Neck& second) {
            return first.depth_mm > second.depth_mm;
        });
        return between;
    }

  private:
    std::size_t root_of(std::size_t basin) {
        return basins_.root(static_cast<std::uint32_t>(basin));
    }

    std::size_t basins_around(std::size_t voxel, std::array<std::size_t, 6>& around) {
        const Grid& grid = depth_.grid;
        const Index3 at = grid.index_of(voxel);
        std::size_t count = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const int step : {1, -1}) {
                Index3 n = at;
                n[axis] += step;
                if (!grid.contains(n[0], n[1], n[2])) continue;
                const std::uint32_t label = labels_.at(n[0], n[1], n[2]);
                if (label != 0) around[count++] = root_of(label - 1);
            }
        return count;
    }

    void meet(std::size_t first, std::size_t second, double neck_mm) {
        const std::size_t a = root_of(first), b = root_of(second);
        if (a == b) return;
        // Basins are added from the deepest on and the smaller index becomes the root, so the root
        // of a merged basin is its deepest.
        const double peak_mm = std::min(peak_mm_[a], peak_mm_[b]);
        if (peak_mm - neck_mm < least_rise_mm || neck_mm > widest_neck * peak_mm)
            basins_.unite(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
        else
            necks_.push_back({a, b, neck_mm});
    }

    const FloatVolume& depth_;
    Image<std::uint32_t> labels_;
    DisjointSets basins_;
    std::vector<double> peak_mm_;
    std::vector<int> number_;  // number of the lobe, by root; -1 for others
    std::vector<Neck> necks_;
};

Lobes Flood::result() {
    Lobes found;
    number_.assign(basins_.size(), -1);
    for (std::size_t i = 0; i < labels_.voxels.size(); ++i) {
        if (labels_.voxels[i] == 0) continue;
        const std::size_t root = root_of(labels_.voxels[i] - 1);
        if (number_[root] < 0) {
            number_[root] = static_cast<int>(found.lobes.size());
            found.lobes.push_back({});
            found.lobes.back().depth_mm = peak_mm_[root];
        }
        const auto lobe = static_cast<std::size_t>(number_[root]);
        labels_.voxels[i] = static_cast<std::uint32_t>(lobe + 1);
        const auto [x, y, z] = labels_.grid.index_of(i);
        found.lobes[lobe].centre_mm += labels_.grid.to_mm(x, y, z);
        ++found.lobes[lobe].voxels;
    }
    for (Lobe& lobe : found.lobes) lobe.centre_mm /= static_cast<double>(lobe.voxels);
    found.labels = std::move(labels_);
    return found;
}

// Attaches every lobe to the tree of the deepest one by the widest necks (Prim's algorithm).
void hang(const std::vector<Neck>& necks, std::vector<Lobe>& lobes) {
    if (lobes.empty()) return;
    std::vector<char> hangs(lobes.size(), 0);
    const auto deepest = std::ranges::max_element(lobes, {}, &Lobe::depth_mm);
    hangs[static_cast<std::size_t>(deepest - lobes.begin())] = 1;
    const auto joins = [&](const Neck& neck) { return hangs[neck.a] != hangs[neck.b]; };
    for (auto neck = std::find_if(necks.begin(), necks.end(), joins); neck != necks.end();
         neck = std::find_if(necks.begin(), necks.end(), joins)) {
        const std::size_t child = hangs[neck->a] != 0 ? neck->b : neck->a;
        lobes[child].parent = static_cast<int>(hangs[neck->a] != 0 ? neck->a : neck->b);
        lobes[child].neck_mm = neck->depth_mm;
        hangs[child] = 1;
    }
}

}  // namespace

Lobes lobes_of(const Mask& region, Job& job) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < region.voxels.size(); ++i)
        if (region.voxels[i] != 0) order.push_back(i);
    FloatVolume depth = distance_to(complement(region), job);
    for (float& mm : depth.voxels) mm = std::min(mm, bottomless_mm);
    job.throw_if_cancelled();
    std::ranges::stable_sort(order, std::ranges::greater{},
                             [&](std::size_t voxel) { return depth.voxels[voxel]; });
    Flood flood(depth);
    for (std::size_t k = 0; k < order.size(); ++k) {
        if (k % voxels_a_check == 0) job.throw_if_cancelled();
        flood.add(order[k]);
    }
    Lobes found = flood.result();
    hang(flood.necks(), found.lobes);
    return found;
}

}  // namespace hepatica
