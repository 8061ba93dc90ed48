// SPDX-License-Identifier: GPL-3.0-or-later
// The small patient with a tumour above the middle of a branch.
#pragma once

#include <memory>

#include "tests/session/small_patient.h"

namespace hepatica::test {

inline constexpr double tumour_radius_mm = 5.0;

inline Vec3 middle_of_tumour() {
    return middle_of(small_patient()->tree, 1) + Vec3(0, 0, 14);
}

inline std::shared_ptr<const PatientCase> patient_with_tumour() {
    auto patient = std::make_shared<PatientCase>(*small_patient());
    Grid grid{{20, 20, 20}};
    grid.origin_mm = middle_of_tumour() - Vec3::Constant(9.5);
    patient->organs = Mask(grid);
    for (std::size_t i = 0; i < patient->organs.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        if ((grid.to_mm(x, y, z) - middle_of_tumour()).norm() <= tumour_radius_mm)
            patient->organs.voxels[i] = organ_label::first_tumour;
    }
    return patient;
}

}  // namespace hepatica::test
