// SPDX-License-Identifier: GPL-3.0-or-later
// What the window forbids while a lesson is played: actions of tools that it does not allow, and
// settings; and while one looks back on a play.
#pragma once

#include <set>
#include <span>

#include "core/lesson/lesson.h"
#include "ui/actions.h"

class QString;
class QWidget;

namespace hepatica {

bool allows(std::span<const LessonTool> tools, LessonTool tool);

// The actions that use other tools than these, reset the play or correct the vessels.
std::set<ActionId> forbidden_actions(std::span<const LessonTool> tools);

// What acts on the play or corrects the vessels: in a review there is nothing to act on.
std::set<ActionId> forbidden_in_review();

// The tools besides pulling, by the names and keys of their actions: "Probe (4), Forceps (6)".
QString in_words(std::span<const LessonTool> tools, const Actions& actions);

// The name of one tool with its key, by its action: "Probe (4)"; empty for settings.
QString tool_and_key(LessonTool tool, const Actions& actions);

// How all of these tools are used without a mouse, in lines; empty where there is none.
QString by_keys(std::span<const LessonTool> tools, const Actions& actions);

// Enables a control, or disables it with a tip that says why.
void set_allowed(QWidget& control, bool allowed);

}  // namespace hepatica
