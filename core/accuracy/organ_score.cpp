// SPDX-License-Identifier: GPL-3.0-or-later
// Counts overlapping voxels and averages distance maps over border voxels.
#include "core/accuracy/organ_score.h"

#include <array>

#include "core/image/filters.h"
#include "core/image/mask.h"
#include "core/image/morphology.h"

namespace hepatica {

namespace {

double share(std::size_t part, std::size_t whole) {
    return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

Mask united(const Mask& a, const Mask& b) {
    Mask both(a.grid);
    for (std::size_t i = 0; i < both.voxels.size(); ++i)
        both.voxels[i] = a.voxels[i] != 0 || b.voxels[i] != 0;
    return both;
}

// Object voxels with a face next to background. A face on the edge of the image is no surface.
Mask border_of(const Mask& mask) {
    const Grid& grid = mask.grid;
    Mask surface(grid);
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        if (mask.voxels[i] == 0) continue;
        const Index3 at = grid.index_of(i);
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const int step : {-1, 1}) {
                Index3 n = at;
                n[axis] += step;
                if (grid.contains(n[0], n[1], n[2]) && mask.at(n[0], n[1], n[2]) == 0)
                    surface.voxels[i] = 1;
            }
    }
    return surface;
}

struct Distances {
    double sum = 0.0;
    std::size_t count = 0;
};

void add_distances(const Mask& from, const Mask& to, Distances& distances, Job& job) {
    const FloatVolume distance = distance_to(to, job);
    for (std::size_t i = 0; i < from.voxels.size(); ++i)
        if (from.voxels[i] != 0) {
            distances.sum += static_cast<double>(distance.voxels[i]);
            ++distances.count;
        }
}

}  // namespace

OrganScore organ_score(const Mask& found, const Mask& truth, Job& job) {
    std::size_t hit = 0, of_found = 0, of_truth = 0;
    for (std::size_t i = 0; i < found.voxels.size(); ++i) {
        const bool f = found.voxels[i] != 0, t = truth.voxels[i] != 0;
        hit += f && t ? 1 : 0;
        of_found += f ? 1 : 0;
        of_truth += t ? 1 : 0;
    }
    OrganScore score;
    score.dice = of_found + of_truth == 0 ? 1.0 : 2.0 * share(hit, of_found + of_truth);
    score.outside_share = share(of_found - hit, of_found);
    score.missed_share = share(of_truth - hit, of_truth);
    if (of_found == 0 || of_truth == 0) return score;
    // Keeps a layer of background around both, so that their whole surfaces stay in the box.
    const IndexBox box =
        grow_box(bounding_box(united(found, truth)), found.grid, found.grid.spacing_mm.maxCoeff());
    const Mask a = border_of(crop(found, box)), b = border_of(crop(truth, box));
    if (object_count(a) == 0 || object_count(b) == 0)
        return score;  // fills the image: no surface to measure to
    Distances distances;
    add_distances(a, b, distances, job);
    add_distances(b, a, distances, job);
    score.surface_mean_mm = distances.sum / static_cast<double>(distances.count);
    return score;
}

}  // namespace hepatica
