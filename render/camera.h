// SPDX-License-Identifier: GPL-3.0-or-later
// How a reader looks at the patient: the standard anatomical views in LPS space (x to the left,
// y to the back, z to the head), and orbit, pan and zoom. Works on VTK's camera; owns nothing.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/vector.h"

class vtkCamera;

namespace hepatica {

enum class ViewDirection { anterior, posterior, left, right, superior, inferior };

const std::vector<ViewDirection>& all_view_directions();
std::string name_of(ViewDirection direction);  // "anterior", ...
// Empty where the name is none of the above.
std::optional<ViewDirection> view_direction_named(const std::string& name);

// Looks at the box from the named side so that all of it fits in a picture of width/height =
// `aspect`. Anterior as radiologists stand: the patient's left is on the right of the picture.
void look_from(vtkCamera& camera, ViewDirection direction, const Vec3& lower_mm,
               const Vec3& upper_mm, double aspect);

// Looks at the box from where it looks now, so that all of it fits.
void look_at_all(vtkCamera& camera, const Vec3& lower_mm, const Vec3& upper_mm, double aspect);

// Turns around the focal point; angles in degrees, to the right and up.
void orbit(vtkCamera& camera, double right_deg, double up_deg);
// Moves camera and focal point by a displacement of the scene, in mm, in the picture's plane.
void pan(vtkCamera& camera, const Vec3& displacement_mm);
// Multiplies the picture's scale by factor > 0; stays at least `closest_mm` from the focal point.
void zoom(vtkCamera& camera, double factor, double closest_mm = 2.0);

}  // namespace hepatica
