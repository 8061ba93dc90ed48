// SPDX-License-Identifier: GPL-3.0-or-later
// The place in the patient that the mouse points at: a mark of the lesson, even where a vessel in
// front hides it, else the vessel. And whether a vessel hides a place.
#pragma once

#include <optional>

#include "render/scene_view.h"

namespace hepatica {

// `pick`: what the view has at the pixel. `spheres_beside`: so many times its radius a mark may be
// away where the pixel is on no vessel; on one its sphere has to cover the pixel. nullopt: neither.
std::optional<Vec3> pointed_place(const SceneView& view, const Pixel& at, const SurfacePick& pick,
                                  double spheres_beside);

// Whether another vessel lies before this place of a vessel, as one looks now; false where nothing
// is at its pixel.
bool is_behind_vessels(const SceneView& view, const Vec3& place_mm);

}  // namespace hepatica
