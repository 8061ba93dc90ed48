// SPDX-License-Identifier: GPL-3.0-or-later
// Table of all actions of the window, from which menus, shortcuts, tips and the cheat sheet are
// made.
#pragma once

#include <QAction>
#include <QKeySequence>
#include <QString>
#include <array>
#include <functional>
#include <map>
#include <set>
#include <span>

class QMenuBar;
class QToolBar;
class QWidget;

namespace hepatica {

struct MouseScheme;

enum class ActionId {
    open_case,
    open_library,
    open_ct_folder,
    open_ct_file,
    open_unsaved,
    open_recording,
    record_play,
    reconstruct,
    built_in,
    save_case,
    save_case_as,
    archive_case,
    save_picture,
    quit,
    pull_mode,
    inject_mode,
    edit_mode,
    sphere_tool,
    capsule_tool,
    forceps_tool,
    hook_tool,
    cut_mode,
    weaken_mode,
    turn_tool,
    turn_tool_back,
    close_or_open,
    put_tool_away,
    choose_threshold,
    undo_edit,
    redo_edit,
    play_pause,
    remove_drug,
    pause_simulation,
    reset,
    restore,
    sounds,
    view_anterior,
    view_posterior,
    view_left,
    view_right,
    view_superior,
    view_inferior,
    toggle_annotations,
    toggle_halos,
    toggle_stretch,
    toggle_blood,
    toggle_liver,
    toggle_volume,
    toggle_clip,
    clip_deeper,
    clip_less_deep,
    toggle_slices,
    toggle_branches,
    toggle_plots,
    toggle_panels,
    full_screen,
    theme_dark,
    theme_light,
    theme_high_contrast,
    measure_distance,
    measure_angle,
    measure_diameter,
    remove_measurement,
    clear_measurements,
    guide,
    cheat_sheet,
    messages,
    about,
};

struct ActionSpec {
    ActionId id;
    const char* menu;  // its menu; "&" marks the mnemonic
    const char* text;
    const char* keys;  // portable text of a QKeySequence; may be empty
    const char* tip;
    bool checkable = false;
    bool needs_patient = false;  // disabled while no patient is shown
};

// All actions, in the order of the menus.
std::span<const ActionSpec> action_table();

// In the order of MeasurementKind.
inline constexpr std::array measuring_actions{ActionId::measure_distance, ActionId::measure_angle,
                                              ActionId::measure_diameter};

// What acts on the vessels' body.
inline constexpr std::array body_actions{
    ActionId::pull_mode, ActionId::sphere_tool, ActionId::capsule_tool, ActionId::forceps_tool,
    ActionId::hook_tool, ActionId::cut_mode,    ActionId::weaken_mode};

// Makes and enables the actions of one window. UI thread only.
class Actions {
  public:
    // Fills the menus in the order of the table. A focused button, combo box or list keeps Space.
    Actions(QWidget& window, QMenuBar& menus);

    QAction& operator[](ActionId id) const { return *actions_.at(id); }
    void on(ActionId id, std::function<void()> run);
    void set_patient_shown(bool shown);
    // What undo and redo would change, in words; empty: nothing, and the action is disabled.
    void show_history(const QString& undo, const QString& redo);
    // Disables an action that has nothing to act on, with the reason as its tip; empty: it has.
    void show_lack(ActionId id, const QString& why);
    // Calls `look` whenever the menu of this action is about to open, which then shows tips.
    void before_menu_of(ActionId id, const std::function<void()>& look);
    // Disables these actions until the next call, with this tip, in which %1 is the action's name.
    void forbid(std::set<ActionId> forbidden, const QString& why);
    // Why an action with these keys is forbidden or has nothing to act on, as its tip says it;
    // empty: there is none such.
    QString objection_to(const QKeySequence& keys) const;

    // All keys and mouse gestures as HTML; those of the camera are the scheme's.
    static QString cheat_sheet(const MouseScheme& scheme);

  private:
    void enable(const ActionSpec& spec);

    std::map<ActionId, QAction*> actions_;
    std::set<ActionId> forbidden_;
    QString why_forbidden_;
    std::map<ActionId, QString> history_;
    std::map<ActionId, QString> lacks_;  // why an action has nothing to act on
    bool patient_shown_ = false;
};

// "measureButton", with the kinds of measurements in a menu. Whoever measures checks it, so that it
// is lit.
void add_measure_button(Actions& actions, QToolBar& bar);

}  // namespace hepatica
