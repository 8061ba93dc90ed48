// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slices/stroke_place.h"

#include <algorithm>

#include "core/patient/painted_tumours.h"
#include "core/patient/patient_case.h"

namespace hepatica {
namespace {

constexpr double far_mm = 25.0;

// Tumours lie in the liver; the vena cava does not.
bool is_liver(std::uint8_t organ) {
    return organ == organ_label::liver || organ >= organ_label::first_tumour;
}

}  // namespace

bool lies_far_outside(const BrushStroke& stroke, const Mask& organs) {
    if (std::ranges::none_of(organs.voxels, is_liver)) return false;
    // The stroke with its radius enlarged by far_mm.
    const BrushStroke reach{stroke.path_mm, stroke.radius_mm + far_mm, false};
    Mask near(organs.grid);
    apply(reach, 1, near);
    for (std::size_t v = 0; v < near.voxels.size(); ++v)
        if (near.voxels[v] != 0 && is_liver(organs.voxels[v])) return false;
    return true;
}

bool tumour_lies_outside(const BrushStroke& stroke, const Mask& organs) {
    constexpr double beside_mm = 5.0;
    if (std::ranges::find(organs.voxels, organ_label::liver) == organs.voxels.end()) return false;
    Mask near(organs.grid);
    apply({stroke.path_mm, stroke.radius_mm + beside_mm, false}, 1, near);
    apply({stroke.path_mm, stroke.radius_mm, false}, 2, near);
    for (std::size_t v = 0; v < near.voxels.size(); ++v) {
        const std::uint8_t organ = organs.voxels[v];
        if (near.voxels[v] != 0 && organ == organ_label::liver) return false;
        if (near.voxels[v] == 1 && is_liver(organ)) return false;
    }
    return true;
}

bool tumour_is_cut_off(const BrushStroke& stroke, const Grid& canvas, const Grid& ct) {
    if (!reaches_beyond(stroke, canvas)) return false;
    bool cut = false;
    sweep(stroke, ct, [&](std::size_t offset) {
        if (cut) return;
        const Index3 here = ct.index_of(offset);
        const Vec3 at = canvas.to_index(ct.to_mm(here[0], here[1], here[2]));
        for (int axis = 0; axis < 3; ++axis)
            cut = cut || at[axis] < -0.75 ||
                  at[axis] > canvas.dims[static_cast<std::size_t>(axis)] - 0.25;
    });
    return cut;
}

}  // namespace hepatica
