// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/tool_in_hand.h"

#include <optional>

namespace hepatica {

namespace {

std::optional<LessonTool> tool_of(const Frame& frame) {
    if (!frame.tool) return frame.grab ? std::optional(LessonTool::pull) : std::nullopt;
    const std::vector<ToolView::Part>& parts = frame.tool->parts;
    if (parts.size() == 2) return frame.tool->has_jaws() ? LessonTool::forceps : LessonTool::hook;
    if (parts.size() != 1) return std::nullopt;
    return parts.front().along_mm().isZero() ? LessonTool::sphere : LessonTool::capsule;
}

}  // namespace

bool is_held(LessonTool tool) {
    return tool <= LessonTool::hook;
}

bool is_in_hand(LessonTool tool, const Frame& frame) {
    return tool_of(frame) == tool;
}

}  // namespace hepatica
