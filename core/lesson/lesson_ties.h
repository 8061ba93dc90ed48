// SPDX-License-Identifier: GPL-3.0-or-later
// Ties the places of a lesson (marks, the drug's target, where its setup cuts) to the vessels that
// it was made on. Who corrects a patient afterwards is told by the ties which places are elsewhere
// now, and no trainee plays a lesson whose goal has moved.
#pragma once

#include <string>
#include <vector>

#include "core/lesson/lesson.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// It is for one case: a lesson for any patient has no vessels of its own, and those of the built-in
// one are never corrected.
bool can_be_tied(const Lesson& lesson);

// Every place of it is tied.
bool is_tied(const Lesson& lesson);

// Ties what is not tied yet to these vessels, which are its patient's; nothing where it cannot be.
void tie(Lesson& lesson, const VesselTree& tree);

// Lets go of all ties: its patient is another one, or his vessels are right as they are.
void untie(Lesson& lesson);

// A sentence for each place that is elsewhere on these vessels than where it was tied; none for
// places that were never tied.
std::vector<std::string> misfits(const Lesson& lesson, const VesselTree& tree);

}  // namespace hepatica
