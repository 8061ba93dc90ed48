// SPDX-License-Identifier: GPL-3.0-or-later
// A plain picture of a frame without OpenGL, for reports that are made without a display: the
// surface from the front, orthographic, its triangles painted from back to front.
#pragma once

#include <QImage>
#include <array>
#include <vector>

#include "core/base/vascular_system.h"
#include "core/scene/frame.h"

namespace hepatica {

struct FramePainting {
    int width = 1100;
    int height = 780;
    std::array<Vec3, 2> box_mm;           // what fits into the picture: its lower and upper corner
    std::vector<VascularSystem> systems;  // per vertex of the whole body
    std::vector<Vec3> marks_mm;           // circles
};

QImage paint(const Frame& frame, const FramePainting& how);

// The box of a frame and a tenth of its size around.
std::array<Vec3, 2> box_of(const Frame& frame);

}  // namespace hepatica
