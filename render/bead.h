// SPDX-License-Identifier: GPL-3.0-or-later
// The small sphere that marks where a vessel is held: the target of a pull, or the forceps' grip.
#pragma once

#include <vtkSmartPointer.h>

class vtkActor;

namespace hepatica {

// Hidden at first. Scaled by the size of a screen point in mm, it has one size at any zoom.
vtkSmartPointer<vtkActor> new_bead();

}  // namespace hepatica
