// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen through everything that is drawn: the tool where vessels or blood hide it.
#pragma once

class vtkActor;

namespace hepatica {

// From now on the actor lies in front of all that is drawn after it, its own parts in their order.
void draw_before_vessels(vtkActor& actor);

}  // namespace hepatica
