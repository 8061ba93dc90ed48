// SPDX-License-Identifier: GPL-3.0-or-later
// The image of a slice, one pixel per voxel: the CT in grey, overlaid with Couinaud segments,
// vessel voxels, tumours and painted voxels. Crosshair, marks and letters are painted later.
#pragma once

#include <QColor>
#include <QImage>
#include <vector>

#include "core/image/slice.h"
#include "ui/slices/segment_overlay.h"
#include "ui/slices/slice_scene.h"

namespace hepatica {

// Colour of what the user puts into the slices: measurements, places, painted voxels.
inline const QColor colour_of_marks(255, 214, 90);

struct SlicePicture {
    QImage image;
    std::vector<SegmentNumber> segment_numbers;  // places in pixels of `image`
};

// The scene must have a CT; `slice` is in [0, slices.count()).
SlicePicture picture_of(const SliceScene& scene, const SliceStack& slices, int slice);

}  // namespace hepatica
