// SPDX-License-Identifier: GPL-3.0-or-later
// What is allowed in a lesson's file and yet can hardly be meant: a tool that the scene has no part
// for, a goal that nothing in the scene can move, a limit that is broken at once, a point that lies
// on another patient.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/lesson/lesson.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// A sentence each, with what would help; none where nothing is doubtful. `folder`: where the
// lesson's file lies, from which its patient's path starts. Of any lesson, one with gaps too.
std::vector<std::string> doubts_about(const Lesson& lesson,
                                      const std::filesystem::path& folder = {});

// Points of the lesson that are not on the vessels of the patient on whom it is to be played.
std::vector<std::string> doubts_about_places(const Lesson& lesson, const VesselTree& tree);

// Points that were clicked on the patient with this tree (they lie on its centreline), while the
// lesson is for another one.
std::vector<std::string> doubts_about_another(const Lesson& lesson, const VesselTree& shown);

}  // namespace hepatica
