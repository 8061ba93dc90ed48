// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the drug front in the vessel's fragment shader: each fragment compares its interpolated
// arrival time with the time since the injection began. Advancing the front costs one uniform a
// frame; no geometry is uploaded for it.
#pragma once

#include "render/palette.h"

class vtkActor;
class vtkOpenGLPolyDataMapper;

namespace hepatica {

struct DrugView;

// The position on the colour map is sqrt(arrival time / end time): the large vessels fill in the
// first few percent of the time, which a linear map would show in one colour.
namespace drug_overlay {

// Name of the point data array with the arrival time of each vertex in seconds.
inline constexpr const char* arrival_array = "arrival_s";
// Stands for "never reached" on the graphics card, where infinity would corrupt the interpolation.
inline constexpr float never_s = 1e9f;

// Adds the overlay to the actor's shaders. Call once per actor.
void attach(vtkActor& actor, vtkOpenGLPolyDataMapper& mapper);

// Sets the time and the end of the colour map, which is at least `least_end_s`. Call every frame;
// it sets two uniforms.
void set_time(vtkActor& actor, const DrugView& drug, double least_end_s = 0.0);

// Distances from the camera in mm between which colours fade into the background.
void set_fade(vtkActor& actor, double near_mm, double far_mm);
// The colour into which they fade.
void set_distance(vtkActor& actor, const Colour& colour);

}  // namespace drug_overlay
}  // namespace hepatica
