// SPDX-License-Identifier: GPL-3.0-or-later
// A real patient reconstructed quickly: coarse voxels and a small body.
#pragma once

#include "core/reconstruction/reconstruct.h"
#include "tests/support/test_data.h"

namespace hepatica::test {

inline constexpr const char* real_cases[] = {"ircadb01_case01", "ircadb01_case07"};

// `folder`: of the case, which may not be there.
inline ReconstructOptions quick_options(const std::filesystem::path& folder) {
    ReconstructOptions options;
    options.ct = folder / "PATIENT_DICOM";
    options.liver_mask = folder / "masks/liver.nii.gz";
    options.spacing_mm = 1.0;
    options.mesh.target_tetrahedra = 1500;
    return options;
}

}  // namespace hepatica::test
