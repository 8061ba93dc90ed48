// SPDX-License-Identifier: GPL-3.0-or-later
// Ties the places of a lesson (marks, the drug's target, places of the setup) to the vessels of its
// patient. If the patient is corrected afterwards, misfits() lists the places that have moved, so
// that no trainee plays a lesson with a displaced goal.
#pragma once

#include <string>
#include <vector>

#include "core/lesson/lesson.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// True for lessons for one case. A lesson for any patient has no vessels of its own, and those of
// the built-in patient never change.
bool can_be_tied(const Lesson& lesson);

// True if every place is tied.
bool is_tied(const Lesson& lesson);

// Ties the untied places to the vessels of the lesson's patient; does nothing if can_be_tied() is
// false. Throws InputError if the tree is empty.
void tie(Lesson& lesson, const VesselTree& tree);

// Removes all ties: for another patient, or to accept the vessels as they are.
void untie(Lesson& lesson);

// One sentence for each place that has moved since it was tied; untied places are skipped.
std::vector<std::string> misfits(const Lesson& lesson, const VesselTree& tree);

}  // namespace hepatica
