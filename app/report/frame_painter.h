// SPDX-License-Identifier: GPL-3.0-or-later
// Draws a plain picture of a frame without OpenGL, for reports that are made without a display: the
// surface from the front, orthographic, with its triangles painted from back to front.
#pragma once

#include <QImage>
#include <array>
#include <cstdint>
#include <vector>

#include "core/base/vascular_system.h"
#include "core/scene/frame.h"

namespace hepatica {

struct FramePainting {
    int width = 1100;
    int height = 780;
    std::array<Vec3, 2> box_mm;           // lower and upper corner of what fits into the picture
    std::vector<VascularSystem> systems;  // per vertex of the untorn body
    std::vector<Vec3> marks_mm;           // drawn as circles
    // Per vertex of the untorn body: not 0 where a lesson wants a drug; empty: nowhere.
    std::vector<std::uint8_t> target{};
};

QImage paint(const Frame& frame, const FramePainting& how);

// The bounding box of a frame, enlarged by a tenth of its size on each side.
std::array<Vec3, 2> box_of(const Frame& frame);

}  // namespace hepatica
