// SPDX-License-Identifier: GPL-3.0-or-later
// The deleting templates of the fully parallel 3-D thinning (Ma and Sonka 1996, corrected by Wang
// and Basu 2007). Directions: W/E = -x/+x, S/N = -y/+y, D/U = -z/+z.
#pragma once

#include <cstdint>
#include <vector>

#include "core/skeleton/padded_object.h"

namespace hepatica {

struct ThinningTemplate {
    std::uint32_t object = 0;      // neighbours that must be object
    std::uint32_t background = 0;  // neighbours that must be background
    // Offsets in memory of voxels up to two steps away. All of `followed` must be object, and at
    // least one of `any_of`, unless that is empty.
    std::vector<std::ptrdiff_t> followed;
    std::vector<std::ptrdiff_t> any_of;
};

// The templates of classes A (6), B (12), C (8) and D (36), for the strides of `object`.
std::vector<ThinningTemplate> thinning_templates(const PaddedObject& object);

// True for line ends and near-line-ends, which no template may delete.
bool is_protected_end(std::uint32_t neighbourhood);

}  // namespace hepatica
