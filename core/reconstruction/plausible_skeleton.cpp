// SPDX-License-Identifier: GPL-3.0-or-later
// Counts the voxels of the long pieces of a skeleton.
#include "core/reconstruction/plausible_skeleton.h"

#include <cstddef>

#include "core/image/morphology.h"
#include "core/tree/tree_extraction.h"

namespace hepatica {

void require_plausible_skeleton(const Mask& skeleton, const Job& job) {
    constexpr double most_mm = 80000.0;
    const double edge_mm = skeleton.grid.spacing_mm.minCoeff();
    const double least_piece_mm = TreeOptions{}.minimum_component_mm;
    const Components pieces = connected_components(skeleton, Connectivity::all26, job);
    double all_mm = 0.0;
    for (const std::size_t voxels : pieces.sizes) {
        const double piece_mm = edge_mm * static_cast<double>(voxels);
        if (piece_mm < least_piece_mm) break;  // the others are no longer
        all_mm += piece_mm;
    }
    require_plausible_length(all_mm, most_mm);
}

}  // namespace hepatica
