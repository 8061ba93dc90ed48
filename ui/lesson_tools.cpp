// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_tools.h"

#include <QString>
#include <QStringList>
#include <QVariant>
#include <QWidget>
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "ui/words.h"

namespace hepatica {
namespace {

constexpr std::array<std::pair<LessonTool, ActionId>, 8> action_of_tool{{
    {LessonTool::pull, ActionId::pull_mode},
    {LessonTool::inject, ActionId::inject_mode},
    {LessonTool::sphere, ActionId::sphere_tool},
    {LessonTool::capsule, ActionId::capsule_tool},
    {LessonTool::forceps, ActionId::forceps_tool},
    {LessonTool::hook, ActionId::hook_tool},
    {LessonTool::blade, ActionId::cut_mode},
    {LessonTool::cut_line, ActionId::weaken_mode},
}};

constexpr const char* own_tip = "ownTip";  // property that keeps a control's own tip

}  // namespace

bool allows(std::span<const LessonTool> tools, LessonTool tool) {
    return std::ranges::find(tools, tool) != tools.end();
}

std::set<ActionId> forbidden_actions(std::span<const LessonTool> tools) {
    // Corrections of the vessels would end the play.
    std::set<ActionId> forbidden{ActionId::reset, ActionId::edit_mode, ActionId::undo_edit,
                                 ActionId::redo_edit, ActionId::choose_threshold};
    for (const auto& [tool, action] : action_of_tool)
        if (!allows(tools, tool)) forbidden.insert(action);
    return forbidden;
}

std::set<ActionId> forbidden_in_review() {
    std::set<ActionId> forbidden = forbidden_actions({});
    forbidden.erase(ActionId::pull_mode);  // there a drag turns the view
    forbidden.insert({ActionId::turn_tool, ActionId::turn_tool_back, ActionId::close_or_open,
                      ActionId::remove_drug, ActionId::restore});
    return forbidden;
}

namespace {

QStringList names_and_keys(std::span<const LessonTool> tools, const Actions& actions) {
    QStringList names;
    for (const auto& [tool, id] : action_of_tool) {
        if (!allows(tools, tool)) continue;
        const QAction& action = actions[id];
        names << QString("%1 (%2)").arg(action.text().remove('&'),
                                        action.shortcut().toString(QKeySequence::NativeText));
    }
    return names;
}

}  // namespace

QString in_words(std::span<const LessonTool> tools, const Actions& actions) {
    std::vector<LessonTool> others(tools.begin(), tools.end());
    std::erase(others, LessonTool::pull);
    return names_and_keys(others, actions).join(", ");
}

QString tool_and_key(LessonTool tool, const Actions& actions) {
    return names_and_keys(std::array{tool}, actions).join(", ");
}

QString by_keys(std::span<const LessonTool> tools, const Actions& actions) {
    const QStringList names = names_and_keys(tools, actions);
    if (names.isEmpty()) return {};
    return Words::tr("By keys: %1").arg(names.join(", ")) + "\n" +
           Words::tr(
               "Enter acts at the cross in the middle of the view. Arrow keys lead what is "
               "held, Page Up and Page Down a tool in depth; Enter or Esc lets go.");
}

void set_allowed(QWidget& control, bool allowed) {
    if (!control.property(own_tip).isValid()) control.setProperty(own_tip, control.toolTip());
    control.setEnabled(allowed);
    control.setToolTip(allowed ? control.property(own_tip).toString()
                               : Words::tr("The lesson does not allow this"));
}

}  // namespace hepatica
