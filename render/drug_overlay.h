// SPDX-License-Identifier: GPL-3.0-or-later
// The drug front as a change to the vessel's shader: every fragment compares its own arrival time
// with the time of the injection. Advancing the front costs one uniform, whatever the vessel does.
#pragma once

class vtkActor;
class vtkOpenGLPolyDataMapper;

namespace hepatica {

struct DrugView;

// Colours rise with the square root of the arrival time, since the first moments, in which the
// large vessels fill, are a small part of all.
namespace drug_overlay {

// Point data array that holds the arrival time in seconds of each vertex.
inline constexpr const char* arrival_array = "arrival_s";
// Stands for "never reached" on the graphics card, where infinity would spoil interpolation.
inline constexpr float never_s = 1e9f;

// Adds the overlay to the actor's shader. Call once.
void attach(vtkActor& actor, vtkOpenGLPolyDataMapper& mapper);

// Sets time and range of the map. Call every frame; costs nothing.
void set_time(vtkActor& actor, const DrugView& drug);

// Depths (mm before the camera) between which colours fade into the background.
void set_fade(vtkActor& actor, double near_mm, double far_mm);

}  // namespace drug_overlay
}  // namespace hepatica
