// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QKeyEvent>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>
#include <QWidget>
#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>

#include "ui/mouse_scheme.h"
#include "ui/tool_icons.h"
#include "ui/words.h"

namespace hepatica {
namespace {

using enum ActionId;

constexpr std::array table{
    ActionSpec{open_case, Words::id("&File"), Words::id("&Open case…"), "Ctrl+O",
               Words::id("Open a patient that was reconstructed")},
    ActionSpec{
        open_library, Words::id("&File"), Words::id("&Library of cases…"), "Ctrl+L",
        Words::id("The cases of a folder: what each holds, what is doubted, how lessons went")},
    ActionSpec{open_ct_folder, Words::id("&File"), Words::id("Open CT &folder…"), "Ctrl+D",
               Words::id("Reconstruct the vessels of a DICOM series")},
    ActionSpec{open_ct_file, Words::id("&File"), Words::id("Open CT f&ile…"), "Ctrl+I",
               Words::id("Reconstruct the vessels of a volume: NIfTI, MetaImage or NRRD")},
    ActionSpec{open_unsaved, Words::id("&File"), Words::id("Open &unsaved work"), "",
               Words::id("Open what an earlier run of the program left without having saved it")},
    ActionSpec{open_recording, Words::id("&File"), Words::id("Open recor&ding…"), "Ctrl+Shift+O",
               Words::id("Look back on a play: its time line, what happened, notes")},
    ActionSpec{record_play, Words::id("&File"), Words::id("Record pla&y"), "F5",
               Words::id("Record the play from now on, and end that; File > Open recording looks "
                         "back on it"),
               true, true},
    ActionSpec{reconstruct, Words::id("&File"), Words::id("&Reconstruct with options…"), "Ctrl+R",
               Words::id("Choose liver mask, seeds and window before reconstructing")},
    ActionSpec{built_in, Words::id("&File"), Words::id("&Built-in patient"), "Ctrl+B",
               Words::id("Open the synthetic patient that comes with the program")},
    ActionSpec{save_case, Words::id("&File"), Words::id("&Save case"), "Ctrl+S",
               Words::id("Keep the patient with all corrections where the case lies"), false, true},
    ActionSpec{save_case_as, Words::id("&File"), Words::id("Save case &as…"), "Ctrl+Shift+S",
               Words::id("Keep the patient as another case: NAME.hep, a folder of open formats, or "
                         "NAME.hepz, one file"),
               false, true},
    ActionSpec{archive_case, Words::id("&File"), Words::id("Export DICO&M segmentation…"), "",
               Words::id("Write vessels, liver and tumours as a segmentation of the CT, for the "
                         "archive and other viewers"),
               false, true},
    ActionSpec{save_picture, Words::id("&File"), Words::id("Save &picture…"), "Ctrl+P",
               Words::id("Save the three-dimensional view as PNG")},
    ActionSpec{quit, Words::id("&File"), Words::id("&Quit"), "Ctrl+Q",
               Words::id("Leave the program")},
    ActionSpec{pull_mode, Words::id("&Play"), Words::id("&Pull"), "1",
               Words::id("Left drag on a vessel pulls it"), true, true},
    ActionSpec{inject_mode, Words::id("&Play"), Words::id("&Inject"), "2",
               Words::id("Left click on a vessel injects there"), true, true},
    ActionSpec{edit_mode, Words::id("&Play"), Words::id("&Edit the vessels"), "3",
               Words::id("Left click on a vessel corrects the tree there"), true, true},
    ActionSpec{sphere_tool, Words::id("&Play"), Words::id("P&robe"), "4",
               Words::id("Probe: the mouse leads a ball that pushes the vessels"), true, true},
    ActionSpec{capsule_tool, Words::id("&Play"), Words::id("Rod pro&be"), "5",
               Words::id("Rod probe: the mouse leads a rod that pushes the vessels"), true, true},
    ActionSpec{forceps_tool, Words::id("&Play"), Words::id("&Forceps"), "6",
               Words::id("Forceps: the mouse leads two jaws that hold a vessel and pull it"), true,
               true},
    ActionSpec{hook_tool, Words::id("&Play"), Words::id("Hoo&k"), "7",
               Words::id("Hook: the mouse leads it, and it holds a vessel aside"), true, true},
    ActionSpec{cut_mode, Words::id("&Play"), Words::id("Bl&ade"), "8",
               Words::id("Blade: a line drawn across a vessel cuts through it"), true, true},
    ActionSpec{
        weaken_mode, Words::id("&Play"), Words::id("Cut &line"), "9",
        Words::id("Cut line: along a line drawn across a vessel it tears more easily when pulled"),
        true, true},
    ActionSpec{turn_tool, Words::id("&Play"), Words::id("&Turn the tool"), "T",
               Words::id("Turn the tool in hand against the clock, by 15°")},
    ActionSpec{turn_tool_back, Words::id("&Play"), Words::id("Turn the tool back"), "Shift+T",
               Words::id("Turn the tool in hand with the clock, by 15°")},
    ActionSpec{close_or_open, Words::id("&Play"), Words::id("&Close or open the forceps"), "C",
               Words::id("The jaws close until they hold, or open again")},
    ActionSpec{
        put_tool_away, Words::id("&Play"), Words::id("Put the tool a&way"), "Esc",
        Words::id(
            "Let go of the vessel; else take the tool out of the picture, or end measuring, and "
            "pull with the mouse again")},
    ActionSpec{choose_threshold, Words::id("&Play"), Words::id("More or fewer &vessels…"), "F4",
               Words::id("Try another threshold in the slices, and make the vessels anew of it"),
               false, true},
    ActionSpec{undo_edit, Words::id("&Play"), Words::id("&Undo"), "Ctrl+Z",
               Words::id("Take back the last correction of the tree"), false, true},
    ActionSpec{redo_edit, Words::id("&Play"), Words::id("Red&o"), "Ctrl+Shift+Z",
               Words::id("Do again what was taken back"), false, true},
    ActionSpec{play_pause, Words::id("&Play"), Words::id("Run the &drug"), "Space",
               Words::id("Start and stop the drug's front"), false, true},
    ActionSpec{remove_drug, Words::id("&Play"), Words::id("Re&move the drug"), "Del",
               Words::id("Take the drug out again"), false, true},
    ActionSpec{pause_simulation, Words::id("&Play"), Words::id("&Hold the clock"), "H",
               Words::id("Stop the simulation; the view stays alive"), true, true},
    ActionSpec{reset, Words::id("&Play"), Words::id("Re&set"), "Backspace",
               Words::id("Back to the rest shape: no pull, no tool, no cut, no drug"), false, true},
    ActionSpec{restore, Words::id("&Play"), Words::id("Back to the last &good state"),
               "Ctrl+Backspace",
               Words::id("After the simulation diverged: take back the last moments and go on"),
               false, true},
    ActionSpec{sounds, Words::id("&Play"), Words::id("Sou&nds"), "",
               Words::id("Tones before something tears, when it tears or bleeds, when a step is "
                         "reached, and at the verdict"),
               true},
    ActionSpec{view_anterior, Words::id("&View"), Words::id("&Anterior"), "A",
               Words::id("Look from the front")},
    ActionSpec{view_posterior, Words::id("&View"), Words::id("&Posterior"), "P",
               Words::id("Look from the back")},
    ActionSpec{view_left, Words::id("&View"), Words::id("&Left"), "L",
               Words::id("Look from the patient's left")},
    ActionSpec{view_right, Words::id("&View"), Words::id("&Right"), "R",
               Words::id("Look from the patient's right")},
    ActionSpec{view_superior, Words::id("&View"), Words::id("&Superior"), "S",
               Words::id("Look from the head")},
    ActionSpec{view_inferior, Words::id("&View"), Words::id("&Inferior"), "I",
               Words::id("Look from the feet")},
    ActionSpec{toggle_annotations, Words::id("&View"), Words::id("Legen&d and scale"), "G",
               Words::id("Show legend, scale bar and orientation"), true},
    ActionSpec{toggle_halos, Words::id("&View"), Words::id("Rims at cr&ossings"), "X",
               Words::id("Set off the nearer of two crossing vessels by a thin rim"), true},
    ActionSpec{toggle_stretch, Words::id("&View"), Words::id("Colour b&y stretch"), "Shift+S",
               Words::id("Colour the vessels by how far they are stretched instead of by system"),
               true, true},
    ActionSpec{toggle_blood, Words::id("&View"), Words::id("Lost blood"), "B",
               Words::id("Show the blood that was lost where a vessel is torn or cut"), true, true},
    ActionSpec{toggle_liver, Words::id("&View"), Words::id("Li&ver"), "V",
               Words::id("Show the surface of the liver around the vessels"), true, true},
    ActionSpec{toggle_volume, Words::id("&View"), Words::id("CT as volu&me"), "Shift+V",
               Words::id("Draw the CT around the vessels: bones, enhanced blood, organs as a haze"),
               true, true},
    ActionSpec{toggle_clip, Words::id("&View"), Words::id("Open the vie&w"), "O",
               Words::id("Take away what lies in front of a plane across the line of sight"), true,
               true},
    ActionSpec{clip_deeper, Words::id("&View"), Words::id("Open it deeper"), "D",
               Words::id("Move that plane 2 mm away from where it was put"), false, true},
    ActionSpec{clip_less_deep, Words::id("&View"), Words::id("Open it less deep"), "Shift+D",
               Words::id("Move that plane 2 mm back"), false, true},
    ActionSpec{toggle_slices, Words::id("&View"), Words::id("Slices of the C&T"), "F7",
               Words::id("Axial, coronal and sagittal slices of the CT beside the vessels"), true},
    ActionSpec{
        toggle_branches, Words::id("&View"), Words::id("Table of &branches"), "F6",
        Words::id("Length, radius, generation, system, liver segment and flow of every branch"),
        true},
    ActionSpec{toggle_plots, Words::id("&View"), Words::id("&Curves"), "F8",
               Words::id("Show the curves of the last injection"), true},
    ActionSpec{toggle_panels, Words::id("&View"), Words::id("Panels"), "F9",
               Words::id("Show the panels beside the view"), true},
    ActionSpec{full_screen, Words::id("&View"), Words::id("&Full screen"), "F11",
               Words::id("The window fills the screen, and back"), true},
    ActionSpec{theme_dark, Words::id("&View"), Words::id("Dar&k"), "",
               Words::id("Dark, as in a reading room"), true},
    ActionSpec{theme_light, Words::id("&View"), Words::id("Li&ght"), "",
               Words::id("Light, for lecture rooms and print"), true},
    ActionSpec{theme_high_contrast, Words::id("&View"), Words::id("&High contrast"), "",
               Words::id("Black and white, for eyes that need more contrast"), true},
    ActionSpec{measure_distance, Words::id("&Measure"), Words::id("&Distance"), "M",
               Words::id("Distance between two clicks on vessels, or in the slices"), true, true},
    ActionSpec{measure_angle, Words::id("&Measure"), Words::id("&Angle"), "Shift+M",
               Words::id("Angle of three clicks on vessels, its vertex second"), true, true},
    ActionSpec{
        measure_diameter, Words::id("&Measure"), Words::id("D&iameter and stenosis"), "Ctrl+M",
        Words::id("Diameter at the centreline of the vessel that is clicked, with its stenosis"),
        true, true},
    ActionSpec{remove_measurement, Words::id("&Measure"), Words::id("&Take the last back"),
               "Shift+Del", Words::id("Remove the last point or measurement"), false, true},
    ActionSpec{clear_measurements, Words::id("&Measure"), Words::id("&Remove all"), "",
               Words::id("Remove everything that was measured"), false, true},
    ActionSpec{guide, Words::id("&Help"), Words::id("&Guide"), "Shift+F1",
               Words::id("How to load a patient, correct the vessels, practise and make lessons")},
    ActionSpec{cheat_sheet, Words::id("&Help"), Words::id("&Keys and mouse"), "F1",
               Words::id("All keys and mouse gestures")},
    ActionSpec{messages, Words::id("&Help"), Words::id("&Messages"), "F2",
               Words::id("What was warned of and what failed since the program began")},
    ActionSpec{about, Words::id("&Help"), Words::id("&About Hepatica"), "",
               Words::id("Version, renderer and licence")},
};

using Rows = std::span<const std::pair<const char*, const char*>>;

// Valid while the 3D view has the keyboard focus; see KeyTool.
constexpr std::array<std::pair<const char*, const char*>, 6> keys_in_the_view{{
    {Words::id("Tab"),
     Words::id("to the view, and on to the panels; a frame shows who has the keys")},
    {Words::id("Arrow keys"), Words::id("turn by 5°; with Shift pan")},
    {Words::id("+ and -"), Words::id("zoom")},
    {Words::id("Home"), Words::id("the whole patient, from where one looks")},
    {Words::id("Enter"),
     Words::id("act at the cross in the middle: take hold of the vessel (Pull), inject, edit, "
               "measure, bring the tool, set the blade down; Ctrl + Enter injects in Pull mode")},
    {Words::id("Arrow keys, then Enter or Esc"),
     Words::id("lead what is held, a tool also in depth by Page Up and Page Down (with Shift five "
               "times as far), then let go")},
}};

constexpr std::array<std::pair<const char*, const char*>, 4> keys_in_slices{{
    {Words::id("Arrow keys in a slice"), Words::id("move the crosshair by a voxel")},
    {Words::id("Page Up, Page Down in a slice"), Words::id("the next slice, the one before")},
    {Words::id("Enter in a slice"), Words::id("do at the crosshair what a click does")},
    {Words::id("Delete in a slice"), Words::id("take the last point or stroke back")},
}};

constexpr std::array<std::pair<const char*, const char*>, 18> gestures{{
    {Words::id("Left drag on a vessel"), Words::id("pull it (in Pull mode)")},
    {Words::id("Left drag beside the vessels"), Words::id("orbit; with Shift pan")},
    {Words::id("Wheel"), Words::id("zoom")},
    {Words::id("Click in Inject mode, Ctrl + click, double-click on a vessel"),
     Words::id("inject there")},
    {Words::id("Click in Edit mode"),
     Words::id("what the panel says: cut, link, delete, root, system")},
    {Words::id("Mouse with a tool in hand"),
     Words::id("lead its tip, in the plane of the picture")},
    {Words::id("Wheel with a tool in hand"),
     Words::id("move it in depth, with Shift five times as far; Ctrl + wheel zooms")},
    {Words::id("Left drag with blade or cut line"),
     Words::id("across a vessel: cut it, or let it tear there")},
    {Words::id("Click on vessels while measuring"),
     Words::id("set the points of a distance, an angle or a diameter")},
    {Words::id("Click on a dashed line"),
     Words::id("bridge that gap; in Edit mode: choose it in the panel")},
    {Words::id("Click on a vessel with slices beside"),
     Words::id("the slices go there (in Pull mode)")},
    {Words::id("Hover"),
     Words::id("show what lies downstream; the panel Injection says its share of the flow")},
    {Words::id("Shift + hover with slices beside"), Words::id("the slices go there")},
    {Words::id("Left drag on a slice"),
     Words::id("move the crosshair; wheel: the slice, with Shift ten of them")},
    {Words::id("Right drag on a slice"),
     Words::id("grey window: its width to the right, its level down")},
    {Words::id("Double-click on a slice"),
     Words::id("enlarge it, and back; Ctrl + wheel zooms, middle drag pans")},
    {Words::id("Alt + wheel with the view open"), Words::id("move the plane that opens it")},
    {Words::id("Drop a file or folder"), Words::id("open it")},
}};

// Gives Space to a focused button, combo box or list, although the table assigns it to an action.
// Filters the window's events, because Qt sends it the shortcut override last.
class SpaceOfTheFocusedWidget : public QObject {
  public:
    explicit SpaceOfTheFocusedWidget(QWidget& window) : QObject(&window), window_(window) {
        window.installEventFilter(this);
    }
    bool eventFilter(QObject* /*window*/, QEvent* event) override {
        if (event->type() != QEvent::ShortcutOverride) return false;
        const auto& key = static_cast<const QKeyEvent&>(*event);
        if (key.key() != Qt::Key_Space || key.modifiers() != Qt::NoModifier || !wanted())
            return false;
        event->accept();
        return true;
    }

  private:
    bool wanted() const {
        const QWidget* focused = window_.focusWidget();
        return qobject_cast<const QAbstractButton*>(focused) != nullptr ||
               qobject_cast<const QComboBox*>(focused) != nullptr ||
               qobject_cast<const QAbstractItemView*>(focused) != nullptr;
    }

    QWidget& window_;
};

void tell(QAction& action, const QString& tip) {
    action.setStatusTip(tip);
    const QString keys = action.shortcut().toString(QKeySequence::NativeText);
    action.setToolTip(keys.isEmpty() ? tip : QString("%1 (%2)").arg(tip, keys));
}

QString plain(const char* text) {
    return Words::tr(text).remove('&').remove("…").trimmed();
}

}  // namespace

std::span<const ActionSpec> action_table() {
    return table;
}

Actions::Actions(QWidget& window, QMenuBar& menus) {
    std::map<QString, QMenu*> menu_named;
    for (const ActionSpec& spec : table) {
        QMenu*& menu = menu_named[spec.menu];
        if (!menu) menu = menus.addMenu(Words::tr(spec.menu));
        auto* action = new QAction(Words::tr(spec.text), &window);
        action->setShortcut(QKeySequence::fromString(spec.keys, QKeySequence::PortableText));
        tell(*action, Words::tr(spec.tip));
        action->setCheckable(spec.checkable);
        action->setIcon(icon_of(spec.id));
        menu->addAction(action);
        window.addAction(action);
        actions_[spec.id] = action;
    }
    // Other programs use either shortcut.
    QAction& redo = *actions_[ActionId::redo_edit];
    redo.setShortcuts({redo.shortcut(), QKeySequence("Ctrl+Y")});
    new SpaceOfTheFocusedWidget(window);  // the window owns it
}

void Actions::on(ActionId id, std::function<void()> run) {
    QObject::connect(actions_.at(id), &QAction::triggered, actions_.at(id), std::move(run));
}

void Actions::set_patient_shown(bool shown) {
    patient_shown_ = shown;
    for (const ActionSpec& spec : table)
        if (spec.needs_patient) enable(spec);
}

void Actions::show_history(const QString& undo, const QString& redo) {
    history_ = {{ActionId::undo_edit, undo}, {ActionId::redo_edit, redo}};
    (*this)[ActionId::undo_edit].setText(undo.isEmpty() ? Words::tr("&Undo")
                                                        : Words::tr("&Undo: %1").arg(undo));
    (*this)[ActionId::redo_edit].setText(redo.isEmpty() ? Words::tr("Red&o")
                                                        : Words::tr("Red&o: %1").arg(redo));
    for (const ActionSpec& spec : table)
        if (history_.contains(spec.id)) enable(spec);
}

void Actions::show_lack(ActionId id, const QString& why) {
    lacks_[id] = why;
    enable(*std::ranges::find(table, id, &ActionSpec::id));
}

void Actions::before_menu_of(ActionId id, const std::function<void()>& look) {
    for (QObject* shows : actions_.at(id)->associatedObjects()) {
        auto* menu = qobject_cast<QMenu*>(shows);
        if (menu == nullptr) continue;
        menu->setToolTipsVisible(true);
        QObject::connect(menu, &QMenu::aboutToShow, actions_.at(id), look);
    }
}

void Actions::forbid(std::set<ActionId> forbidden, const QString& why) {
    const std::set<ActionId> before = std::exchange(forbidden_, std::move(forbidden));
    why_forbidden_ = why;
    for (const ActionSpec& spec : table)
        if (forbidden_.contains(spec.id) || before.contains(spec.id)) enable(spec);
}

QString Actions::objection_to(const QKeySequence& keys) const {
    const auto has_keys = [&](ActionId id) { return actions_.at(id)->shortcuts().contains(keys); };
    for (const ActionId id : forbidden_)
        if (has_keys(id)) return actions_.at(id)->statusTip();
    for (const auto& [id, why] : lacks_)
        if (!why.isEmpty() && has_keys(id)) return why;
    return {};
}

void Actions::enable(const ActionSpec& spec) {
    QAction& action = *actions_.at(spec.id);
    const bool forbidden = forbidden_.contains(spec.id);
    const auto history = history_.find(spec.id);
    const bool nothing_to_do = history != history_.end() && history->second.isEmpty();
    const auto lack = lacks_.find(spec.id);
    const bool lacks = lack != lacks_.end() && !lack->second.isEmpty();
    action.setEnabled(!forbidden && !nothing_to_do && !lacks &&
                      (patient_shown_ || !spec.needs_patient));
    const QString tip = lacks ? lack->second : Words::tr(spec.tip);
    tell(action, forbidden ? why_forbidden_.arg(plain(spec.text)) : tip);
}

QString Actions::cheat_sheet(const MouseScheme& scheme) {
    QString html = "<table cellspacing='6'>";
    const auto row = [&](const QString& left, const QString& right) {
        html += "<tr><td><b>" + left.toHtmlEscaped() + "</b></td><td>" + right.toHtmlEscaped() +
                "</td></tr>";
    };
    const auto heading = [&](const QString& text) {
        html += "<tr><td colspan='2'><h3>" + text.toHtmlEscaped() + "</h3></td></tr>";
    };
    const auto group = [&](const QString& title, Rows rows) {
        heading(title);
        for (const auto& [left, right] : rows) row(Words::tr(left), Words::tr(right));
    };
    group(Words::tr("Mouse"), gestures);
    row(Words::tr("Other drags, as chosen in View > Mouse"), Words::tr(scheme.tip));
    group(Words::tr("Keys in the view of the vessels"), keys_in_the_view);
    group(Words::tr("Keys in a slice"), keys_in_slices);
    const char* menu = "";
    for (const ActionSpec& spec : table) {
        if (!*spec.keys) continue;
        if (std::string_view(menu) != spec.menu)
            heading(Words::tr("Menu %1").arg(plain(menu = spec.menu)));
        const QString name = plain(spec.text) + ": ", tip = Words::tr(spec.tip);
        row(QKeySequence::fromString(spec.keys).toString(QKeySequence::NativeText),
            tip.startsWith(name) ? tip : name + tip);
    }
    return html + "</table>";
}

void add_measure_button(Actions& actions, QToolBar& bar) {
    auto* button = new QToolButton(&bar);
    button->setObjectName("measureButton");
    button->setIcon(actions[ActionId::measure_distance].icon());
    const QString name = Words::tr("&Measure").remove('&');
    button->setToolTip(name);
    button->setAccessibleName(name);
    button->setIconSize(bar.iconSize());
    button->setAutoRaise(true);
    button->setCheckable(true);
    button->setFocusPolicy(Qt::NoFocus);
    button->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(button);
    for (const ActionId id : measuring_actions) menu->addAction(&actions[id]);
    button->setMenu(menu);
    bar.addWidget(button);
}

}  // namespace hepatica
