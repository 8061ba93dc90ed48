// SPDX-License-Identifier: GPL-3.0-or-later
// What the pages of the lesson editor call the tools.
#pragma once

#include <array>
#include <utility>

#include "core/lesson/lesson.h"
#include "ui/words.h"

namespace hepatica {

// In the order of LessonTool; to be translated.
inline constexpr std::array<std::pair<LessonTool, const char*>, 9> tool_words{
    {{LessonTool::pull, Words::id("Pull by hand")},
     {LessonTool::sphere, Words::id("Round probe")},
     {LessonTool::capsule, Words::id("Rod")},
     {LessonTool::forceps, Words::id("Forceps")},
     {LessonTool::hook, Words::id("Hook")},
     {LessonTool::blade, Words::id("Blade")},
     {LessonTool::cut_line, Words::id("Cut line")},
     {LessonTool::inject, Words::id("Injection")},
     {LessonTool::settings, Words::id("Settings: gravity, tissue, tearing, the drug's clock")}}};

}  // namespace hepatica
