// SPDX-License-Identifier: GPL-3.0-or-later
// Orders the slices of a folder into one CT series with reliable geometry, or refuses with an error
// that names the file. The toolkits only warn about a missing slice and return a wrong spacing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "core/image/dicom_slices.h"
#include "core/image/volume.h"

namespace hepatica {

struct OrderedSeries {
    std::vector<DicomSlice> slices;  // ordered along their normal
    // Slices at the position of another one, with the index in `slices` of that one. The caller
    // must check whether they show the same.
    std::vector<std::pair<std::size_t, DicomSlice>> repeated;
    double slice_spacing_mm = 0.0;  // along the normal
    // Angle between the normal and the line on which the slices lie, if a tilted gantry has sheared
    // the series; else 0.
    double tilt_degrees = 0.0;
};

// The slice that lies furthest from its place on the even grid from the first slice to the last, if
// it lies more than half a step from it. `levels_mm` ascend along the normal; `places` are their
// numbers on the grid, ascending from 0.
std::optional<std::size_t> furthest_astray(std::span<const double> levels_mm,
                                           std::span<const std::int64_t> places);

// Throws InputError where sizes, spacings or orientations differ, or a slice lacks them or cannot
// be read.
void require_one_shape(const std::vector<DicomSlice>& slices);

// Throws InputError as require_one_shape() does, and where the series has only one slice, is
// sheared by more than any gantry tilts (45 degrees), slices are missing, the gaps are uneven, or
// they change so slowly that slices lie astray all the same.
OrderedSeries order_slices(std::vector<DicomSlice> series);

}  // namespace hepatica
