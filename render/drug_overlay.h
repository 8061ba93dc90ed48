// SPDX-License-Identifier: GPL-3.0-or-later
// The drug front as an addition to the vessel's fragment shader: each fragment compares its own
// arrival time with the time since the injection began. To advance the front costs one uniform a
// frame; no geometry is uploaded for it, at rest or while the vessel moves.
#pragma once

#include "render/palette.h"

class vtkActor;
class vtkOpenGLPolyDataMapper;

namespace hepatica {

struct DrugView;

// The place on the colour map is the square root of arrival time over end: the large vessels fill
// in the first few percent of the time, which a linear map would show in one colour.
namespace drug_overlay {

// Point data array that holds the arrival time in seconds of each vertex.
inline constexpr const char* arrival_array = "arrival_s";
// Stands for "never reached" on the graphics card, where infinity would spoil interpolation.
inline constexpr float never_s = 1e9f;

// Adds the overlay to the actor's shader. Call once.
void attach(vtkActor& actor, vtkOpenGLPolyDataMapper& mapper);

// Sets time and range of the map, which ends at `least_end_s` or later. Call every frame; costs
// nothing.
void set_time(vtkActor& actor, const DrugView& drug, double least_end_s = 0.0);

// Depths (mm before the camera) between which colours fade into the background.
void set_fade(vtkActor& actor, double near_mm, double far_mm);
// The colour into which they fade.
void set_distance(vtkActor& actor, const Colour& colour);

}  // namespace drug_overlay
}  // namespace hepatica
