// SPDX-License-Identifier: GPL-3.0-or-later
// What is painted of a slice below crosshair, marks and letters, one pixel a voxel: the CT in grey,
// and over it Couinaud's segments, the vessels' voxels, tumours and what is painted by hand.
#pragma once

#include <QColor>
#include <QImage>
#include <vector>

#include "core/image/slice.h"
#include "render/palette.h"
#include "ui/slices/segment_overlay.h"
#include "ui/slices/slice_scene.h"

namespace hepatica {

// Of what a person puts into the slices: measurements, places, painted voxels.
inline const QColor colour_of_marks(255, 214, 90);

QColor colour_of(const Colour& colour);

struct SlicePicture {
    QImage image;
    std::vector<SegmentNumber> segment_numbers;  // in it
};

// Of a scene with a CT.
SlicePicture picture_of(const SliceScene& scene, const SliceStack& slices, int slice);

}  // namespace hepatica
