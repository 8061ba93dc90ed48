// SPDX-License-Identifier: GPL-3.0-or-later
// Camera movements: the standard anatomical views in LPS space (x to the left, y to the back, z to
// the head), and orbit, pan and zoom. They change a vtkCamera and keep no state.
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
// Empty where no direction has this name.
std::optional<ViewDirection> view_direction_named(const std::string& name);

// Looks at the box from the given side so that all of it fits in a picture of width/height =
// `aspect`. The anterior view follows the radiological convention: the patient's left is on the
// right of the picture.
void look_from(vtkCamera& camera, ViewDirection direction, const Vec3& lower_mm,
               const Vec3& upper_mm, double aspect);

// Keeps the viewing direction and changes the distance so that the whole box fits.
void look_at_all(vtkCamera& camera, const Vec3& lower_mm, const Vec3& upper_mm, double aspect);

// Turns the camera around the focal point; angles in degrees, to the right and up.
void orbit(vtkCamera& camera, double right_deg, double up_deg);
// Moves the scene in the picture's plane by `displacement_mm`, that is, camera and focal point by
// its negative.
void pan(vtkCamera& camera, const Vec3& displacement_mm);
// Multiplies the picture's scale by `factor` > 0; the camera stays at least `closest_mm` from the
// focal point.
void zoom(vtkCamera& camera, double factor, double closest_mm = 2.0);

}  // namespace hepatica
