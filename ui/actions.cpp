// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QKeyEvent>
#include <QMenu>
#include <QMenuBar>
#include <QWidget>
#include <array>
#include <utility>

#include "ui/tool_icons.h"

namespace hepatica {
namespace {

using enum ActionId;

constexpr std::array table{
    ActionSpec{open_case, "&File", "&Open case…", "Ctrl+O",
               "Open a patient that was reconstructed"},
    ActionSpec{open_library, "&File", "&Library of cases…", "Ctrl+L",
               "The cases of a folder: what each holds, what is doubted, how lessons went"},
    ActionSpec{open_ct_folder, "&File", "Open CT &folder…", "Ctrl+D",
               "Reconstruct the vessels of a DICOM series"},
    ActionSpec{open_ct_file, "&File", "Open CT f&ile…", "Ctrl+I",
               "Reconstruct the vessels of a volume: NIfTI, MetaImage or NRRD"},
    ActionSpec{open_unsaved, "&File", "Open &unsaved work", "",
               "Open what an earlier run of the program left without having saved it"},
    ActionSpec{open_recording, "&File", "Open recor&ding…", "Ctrl+Shift+O",
               "Look back on a play: its time line, what happened, notes"},
    ActionSpec{reconstruct, "&File", "&Reconstruct with options…", "Ctrl+R",
               "Choose liver mask, seeds and window before reconstructing"},
    ActionSpec{built_in, "&File", "&Built-in patient", "Ctrl+B",
               "Open the synthetic patient that comes with the program"},
    ActionSpec{save_case, "&File", "&Save case", "Ctrl+S",
               "Keep the patient with all corrections where the case lies", false, true},
    ActionSpec{save_case_as, "&File", "Save case &as…", "Ctrl+Shift+S",
               "Keep the patient as another case: NAME.hep, a folder of open formats, or "
               "NAME.hepz, one file",
               false, true},
    ActionSpec{save_picture, "&File", "Save &picture…", "Ctrl+P",
               "Save the three-dimensional view as PNG"},
    ActionSpec{quit, "&File", "&Quit", "Ctrl+Q", "Leave the program"},
    ActionSpec{pull_mode, "&Play", "&Pull", "1", "Left drag on a vessel pulls it", true},
    ActionSpec{inject_mode, "&Play", "&Inject", "2", "Left click on a vessel injects there", true},
    ActionSpec{edit_mode, "&Play", "&Edit the vessels", "3",
               "Left click on a vessel corrects the tree there", true},
    ActionSpec{sphere_tool, "&Play", "P&robe", "4",
               "Probe: the mouse leads a ball that pushes the vessels", true},
    ActionSpec{capsule_tool, "&Play", "Rod pro&be", "5",
               "Probe: the mouse leads a rod that pushes the vessels", true},
    ActionSpec{forceps_tool, "&Play", "&Forceps", "6",
               "Forceps: the mouse leads two jaws that hold a vessel and pull it", true},
    ActionSpec{hook_tool, "&Play", "Hoo&k", "7",
               "Hook: the mouse leads it, and it holds a vessel aside", true},
    ActionSpec{cut_mode, "&Play", "&Blade", "8",
               "Blade: a line drawn across a vessel cuts through it", true},
    ActionSpec{weaken_mode, "&Play", "Cut &line", "9",
               "Cut line: along a line drawn across a vessel it tears more easily when pulled",
               true},
    ActionSpec{turn_tool, "&Play", "&Turn the tool", "T",
               "Turn the tool in hand against the clock, by 15°"},
    ActionSpec{turn_tool_back, "&Play", "Turn the tool bac&k", "Shift+T",
               "Turn the tool in hand with the clock, by 15°"},
    ActionSpec{close_or_open, "&Play", "&Close or open the forceps", "C",
               "The jaws close until they hold, or open again"},
    ActionSpec{put_tool_away, "&Play", "Put the tool a&way", "Esc",
               "Take the tool out of the picture, or end measuring, and pull with the mouse again; "
               "once more takes measurements away"},
    ActionSpec{undo_edit, "&Play", "&Undo the last edit", "Ctrl+Z",
               "Take back the last correction of the tree", false, true},
    ActionSpec{redo_edit, "&Play", "Red&o the edit", "Ctrl+Shift+Z", "Do again what was taken back",
               false, true},
    ActionSpec{play_pause, "&Play", "Run the &drug", "Space", "Start and stop the drug's front",
               false, true},
    ActionSpec{remove_drug, "&Play", "Re&move the drug", "Del", "Take the drug out again", false,
               true},
    ActionSpec{pause_simulation, "&Play", "&Hold the clock", "H",
               "Stop the simulation; the view stays alive", true, true},
    ActionSpec{reset, "&Play", "&Reset", "Backspace",
               "Back to the rest shape: no pull, no tool, no drug", false, true},
    ActionSpec{restore, "&Play", "Back to the last &good state", "Ctrl+Backspace",
               "After the simulation diverged: take back the last moments and go on", false, true},
    ActionSpec{view_anterior, "&View", "&Anterior", "A", "Look from the front"},
    ActionSpec{view_posterior, "&View", "&Posterior", "P", "Look from the back"},
    ActionSpec{view_left, "&View", "&Left", "L", "Look from the patient's left"},
    ActionSpec{view_right, "&View", "&Right", "R", "Look from the patient's right"},
    ActionSpec{view_superior, "&View", "&Superior", "S", "Look from the head"},
    ActionSpec{view_inferior, "&View", "&Inferior", "I", "Look from the feet"},
    ActionSpec{toggle_annotations, "&View", "Le&gend and scale", "G",
               "Show legend, scale bar and orientation", true},
    ActionSpec{toggle_halos, "&View", "Rims at &crossings", "X",
               "Set off the nearer of two crossing vessels by a thin rim", true},
    ActionSpec{toggle_liver, "&View", "Li&ver", "V",
               "Show the surface of the liver around the vessels", true, true},
    ActionSpec{toggle_clip, "&View", "&Open the view", "O",
               "Take away what lies in front of a plane across the line of sight", true, true},
    ActionSpec{clip_deeper, "&View", "Open it &deeper", "D",
               "Move that plane 2 mm away from where it was put", false, true},
    ActionSpec{clip_less_deep, "&View", "Open it less dee&p", "Shift+D",
               "Move that plane 2 mm back", false, true},
    ActionSpec{toggle_slices, "&View", "Slices of the C&T", "F7",
               "Axial, coronal and sagittal slices of the CT beside the vessels", true},
    ActionSpec{toggle_branches, "&View", "Table of &branches", "F6",
               "Length, radius, generation, system, liver segment and flow of every branch", true},
    ActionSpec{toggle_plots, "&View", "&Curves", "F8", "Show the curves of the last injection",
               true},
    ActionSpec{toggle_panels, "&View", "Pa&nels", "F9", "Show the panels beside the view", true},
    ActionSpec{full_screen, "&View", "&Full screen", "F11", "The window fills the screen, and back",
               true},
    ActionSpec{theme_dark, "&View", "Dar&k", "", "Dark, as in a reading room", true},
    ActionSpec{theme_light, "&View", "L&ight", "", "Light, for lecture rooms and print", true},
    ActionSpec{theme_high_contrast, "&View", "&High contrast", "",
               "Black and white, for eyes that need more contrast", true},
    ActionSpec{measure_distance, "&Measure", "&Distance", "M",
               "Distance between two clicks on vessels, or in the slices", true, true},
    ActionSpec{measure_angle, "&Measure", "&Angle", "Shift+M",
               "Angle of three clicks on vessels, its vertex second", true, true},
    ActionSpec{measure_diameter, "&Measure", "D&iameter and stenosis", "Ctrl+M",
               "Diameter at the centreline of the vessel that is clicked, with its stenosis", true,
               true},
    ActionSpec{remove_measurement, "&Measure", "&Take the last back", "Shift+Del",
               "Remove the last point or measurement", false, true},
    ActionSpec{clear_measurements, "&Measure", "&Remove all", "",
               "Remove everything that was measured", false, true},
    ActionSpec{guide, "&Help", "&Guide", "Shift+F1",
               "How to load a patient, correct the vessels, practise and make lessons"},
    ActionSpec{cheat_sheet, "&Help", "&Keys and mouse", "F1", "All keys and mouse gestures"},
    ActionSpec{messages, "&Help", "&Messages", "F2",
               "What was warned of and what failed since the program began"},
    ActionSpec{about, "&Help", "&About Hepatica", "", "Version, renderer and licence"},
};

constexpr std::array<std::pair<const char*, const char*>, 18> gestures{{
    {"Left drag on a vessel", "pull it (in Pull mode)"},
    {"Left drag beside the vessels, right drag", "orbit"},
    {"Middle drag, Shift + left drag", "pan"},
    {"Wheel", "zoom"},
    {"Click in Inject mode, Ctrl + click, double-click on a vessel", "inject there"},
    {"Click in Edit mode", "what the panel says: cut, link, delete, root, system"},
    {"Mouse with a tool in hand", "lead its tip, in the plane of the picture"},
    {"Wheel with a tool in hand", "move it in depth; Ctrl + wheel zooms"},
    {"Left drag with blade or cut line", "across a vessel: cut it, or let it tear there"},
    {"Click on vessels while measuring", "set the points of a distance, an angle or a diameter"},
    {"Click on a dashed line", "bridge that gap"},
    {"Hover", "show what lies downstream, and its share of the flow"},
    {"Shift + hover with slices beside", "the slices go there"},
    {"Left drag on a slice", "move the crosshair; wheel: the slice, with Shift ten of them"},
    {"Right drag on a slice", "grey window: its width to the right, its level down"},
    {"Double-click on a slice", "enlarge it, and back; Ctrl + wheel zooms, middle drag pans"},
    {"Alt + wheel with the view open", "move the plane that opens it"},
    {"Drop a file or folder", "open it"},
}};

// Gives Space to the focused widget where that answers to it, as check boxes and lists do, although
// the table gives it to an action. Filters the events of the window, which Qt asks last.
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

QString plain(const char* text) {
    return QString::fromUtf8(text).remove('&').remove("…");
}

}  // namespace

std::span<const ActionSpec> action_table() {
    return table;
}

Actions::Actions(QWidget& window, QMenuBar& menus) {
    std::map<QString, QMenu*> menu_named;
    for (const ActionSpec& spec : table) {
        QMenu*& menu = menu_named[spec.menu];
        if (!menu) menu = menus.addMenu(spec.menu);
        auto* action = new QAction(QString::fromUtf8(spec.text), &window);
        action->setShortcut(QKeySequence::fromString(spec.keys, QKeySequence::PortableText));
        action->setStatusTip(spec.tip);
        const QString keys = action->shortcut().toString(QKeySequence::NativeText);
        action->setToolTip(keys.isEmpty() ? QString(spec.tip)
                                          : QString("%1 (%2)").arg(spec.tip, keys));
        action->setCheckable(spec.checkable);
        action->setIcon(icon_of(spec.id));
        menu->addAction(action);
        window.addAction(action);
        actions_[spec.id] = action;
    }
    new SpaceOfTheFocusedWidget(window);  // the window owns it
}

void Actions::on(ActionId id, std::function<void()> run) {
    QObject::connect(actions_.at(id), &QAction::triggered, actions_.at(id), std::move(run));
}

void Actions::set_patient_shown(bool shown) {
    for (const ActionSpec& spec : table) {
        if (spec.needs_patient) actions_.at(spec.id)->setEnabled(shown);
    }
}

QString Actions::cheat_sheet() {
    QString html = "<table cellspacing='6'>";
    const auto row = [&](const QString& left, const QString& right) {
        html += "<tr><td><b>" + left.toHtmlEscaped() + "</b></td><td>" + right.toHtmlEscaped() +
                "</td></tr>";
    };
    for (const auto& [gesture, effect] : gestures) row(gesture, effect);
    for (const ActionSpec& spec : table) {
        if (*spec.keys) {
            row(QKeySequence::fromString(spec.keys).toString(QKeySequence::NativeText),
                plain(spec.text) + ": " + spec.tip);
        }
    }
    return html + "</table>";
}

}  // namespace hepatica
