// SPDX-License-Identifier: GPL-3.0-or-later
// Finds what a lesson's file may contain but hardly intends: a tool without the part of the scene
// that it needs, a goal that nothing in the scene can reach, a limit that is broken at once, a
// point on another patient's vessels.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/lesson/lesson.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// One sentence per doubt, with advice; empty if there is none. `folder`: of the lesson's file, from
// which the patient's path is resolved. The lesson may have gaps.
std::vector<std::string> doubts_about(const Lesson& lesson,
                                      const std::filesystem::path& folder = {});

// Points that lie off the vessels of the lesson's patient. Throws InputError if the tree is empty
// and the lesson has points.
std::vector<std::string> doubts_about_places(const Lesson& lesson, const VesselTree& tree);

// Points that lie on this tree's centreline, so were clicked on its patient, although the lesson is
// for another one. Throws InputError as above.
std::vector<std::string> doubts_about_another(const Lesson& lesson, const VesselTree& shown);

}  // namespace hepatica
