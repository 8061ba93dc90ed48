// SPDX-License-Identifier: GPL-3.0-or-later
// Settings that several actors have in common.
#pragma once

#include <vtkAbstractMapper.h>
#include <vtkActor.h>
#include <vtkPlane.h>
#include <vtkProperty.h>

#include "render/palette.h"

namespace hepatica {

inline void give_colour(vtkActor& actor, const Colour& colour) {
    actor.GetProperty()->SetColor(colour[0], colour[1], colour[2]);
}

// Cuts what the mapper draws by this plane alone; null: by none.
inline void clip_by(vtkPlane* plane, vtkAbstractMapper& mapper) {
    mapper.RemoveAllClippingPlanes();
    if (plane) mapper.AddClippingPlane(plane);
}

// The same for the actor of a closed surface, whose inside shows where it is cut open.
inline void clip_by(vtkPlane* plane, vtkAbstractMapper& mapper, vtkActor& actor) {
    clip_by(plane, mapper);
    actor.GetProperty()->SetBackfaceCulling(plane == nullptr);
}

}  // namespace hepatica
