// SPDX-License-Identifier: GPL-3.0-or-later
// Which tool the hand of a play holds, as its frames show it: a step of a lesson may ask for one.
#pragma once

#include "core/lesson/lesson.h"
#include "core/scene/frame.h"

namespace hepatica {

// Whether a hand holds the tool while it acts: pulling, the probes, the forceps and the hook. The
// others act at once, and no step can ask for them.
bool is_held(LessonTool tool);

// Whether the frame shows this tool, or for `pull` a vessel held by hand. A tool is told by its
// shape. False for tools that are never held.
bool is_in_hand(LessonTool tool, const Frame& frame);

}  // namespace hepatica
