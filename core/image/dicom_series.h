// SPDX-License-Identifier: GPL-3.0-or-later
// From the slices of a folder to one CT series whose geometry can be trusted, or a refusal that
// names the file: the toolkits only warn of a missing slice and return a wrong spacing.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "core/image/dicom_slices.h"
#include "core/image/volume.h"

namespace hepatica {

struct OrderedSeries {
    std::vector<DicomSlice> slices;  // from the first to the last along their normal
    // Slices that lie where another one does, with the index in `slices` of that one. Whether they
    // show the same is for the caller to see.
    std::vector<std::pair<std::size_t, DicomSlice>> repeated;
    double slice_spacing_mm = 0.0;  // along the normal
    // Between the normal and the line on which the slices lie, where a tilted gantry has sheared
    // the series; 0 where they lie straight behind one another.
    double tilt_degrees = 0.0;
};

// Throws InputError where sizes, spacings or orientations differ, or one of the slices lacks them
// or cannot be read at all.
void require_one_shape(const std::vector<DicomSlice>& slices);

// Throws InputError where sizes, spacings or orientations differ, the series is sheared by more
// than any gantry tilts, slices are missing or gaps uneven.
OrderedSeries order_slices(std::vector<DicomSlice> series);

}  // namespace hepatica
