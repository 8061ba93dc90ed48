// SPDX-License-Identifier: GPL-3.0-or-later
// Makes an actor visible through everything else. Used to show the tool where vessels or blood hide
// it.
#pragma once

class vtkActor;

namespace hepatica {

// From now on the actor is in front of everything that is drawn after it. The depth order of its
// own parts is kept.
void draw_before_vessels(vtkActor& actor);

}  // namespace hepatica
