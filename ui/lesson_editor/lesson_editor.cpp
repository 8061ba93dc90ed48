// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_editor/lesson_editor.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcut>
#include <QTabWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <exception>
#include <utility>

#include "core/base/error.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_gaps.h"
#include "core/lesson/lesson_writer.h"
#include "core/lesson/target_region.h"
#include "ui/core_words.h"
#include "ui/lesson_editor/about_page.h"
#include "ui/lesson_editor/doubts_in_words.h"
#include "ui/lesson_editor/new_parts.h"
#include "ui/lesson_editor/places_page.h"
#include "ui/lesson_editor/rules_page.h"
#include "ui/lesson_editor/steps_page.h"
#include "ui/on_screen.h"
#include "ui/paths.h"
#include "ui/push_button.h"
#include "ui/words.h"

namespace hepatica {
namespace {

void refuse_gaps(const Lesson& lesson, const char* what) {
    const std::vector<std::string> gaps = gaps_in(lesson);
    if (!gaps.empty())
        throw InputError(gaps.front(), what, Words::id("What is missing stands at its foot"));
}

Vec3 place_on(const VesselTree& tree, const ScriptPlace& place) {
    return place.point_mm ? *place.point_mm
                          : point_on_longest_path(tree, place.share_of_longest_path.value_or(0.0));
}

}  // namespace

LessonEditor::LessonEditor(Ways ways, std::filesystem::path kept_copy, QWidget* parent)
    : QWidget(parent, Qt::Dialog),
      ways_(std::move(ways)),
      document_(std::move(kept_copy)),
      pages_(new QTabWidget),
      doubts_(new QLabel),
      accept_(new QPushButton(Words::tr("The places are &right as they lie now"))),
      keep_(new QTimer(this)) {
    setObjectName("lessonEditor");
    resize_on_screen(*this, {640, 700});
    keep_->setSingleShot(true);
    keep_->setInterval(500);
    connect(keep_, &QTimer::timeout, this, [this] { keep_now(); });
    build();
}

// Qt closes the window when the members are gone, and the field that then loses the focus would
// still change the lesson. Not hidden here, as a course editor is: that would keep a draft which
// was let go, and call the window that owns the editor, of which little is left.
LessonEditor::~LessonEditor() {
    for (QObject* part : findChildren<QObject*>()) part->blockSignals(true);
}

void LessonEditor::build() {
    const LessonPage::Changes changes{
        [this](const std::string& field, const std::function<void(Lesson&)>& change) {
            if (document_.change(field, change)) changed(false);
        },
        [this](const std::function<void(Lesson&)>& change) {
            document_.change("", change);
            changed(true);
        }};
    about_ = new AboutPage(changes, ways_.shown_patient);
    places_ = new PlacesPage(
        changes, ways_.ask_for_place, ways_.ask_no_more, [this] { return targets(); },
        [this](const ScriptPlace& place) { return is_hidden(place); });
    auto* steps = new StepsPage(changes);
    auto* rules = new RulesPage(changes);
    shown_pages_ = {about_, places_, steps, rules};
    pages_->setObjectName("lessonPages");
    pages_->addTab(scrolled(about_), Words::tr("&Lesson"));
    pages_->addTab(scrolled(places_), Words::tr("&Places"));
    pages_->addTab(steps, Words::tr("&Steps"));  // scrolls the part below its list by itself
    pages_->addTab(scrolled(rules), Words::tr("Limits and pass &marks"));
    connect(pages_, &QTabWidget::currentChanged, this, [this] { show_page(); });
    doubts_->setObjectName("lessonDoubts");
    doubts_->setWordWrap(true);
    doubts_->setTextFormat(Qt::PlainText);
    doubts_->setAccessibleName(Words::tr("What is doubtful in this lesson"));
    accept_->setObjectName("lessonAcceptPlaces");
    accept_->setToolTip(
        Words::tr("The vessels were corrected since the lesson was made: look at each place, "
                  "put it elsewhere where that is needed, then say so here and save"));
    connect(accept_, &QPushButton::clicked, this, [this] { accept_places(); });
    auto* foot = new QWidget;
    build_buttons(*foot);
    build_keys();
    auto* column = new QVBoxLayout(this);
    column->addWidget(pages_, 1);
    column->addWidget(doubts_);
    column->addWidget(accept_, 0, Qt::AlignLeft);
    column->addWidget(foot);
}

// Lets the window fit on a small screen.
QWidget* LessonEditor::scrolled(LessonPage* page) {
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(page);
    return scroll;
}

void LessonEditor::build_buttons(QWidget& foot) {
    auto* row = new QHBoxLayout(&foot);
    row->setContentsMargins(0, 0, 0, 0);
    QPushButton* begin = add_button(*row, Words::tr("&Begin with"), "lessonBegin", [] {});
    auto* menu = new QMenu(begin);
    connect(menu->addAction(Words::tr("A new lesson")), &QAction::triggered, this,
            [this] { begin_with(""); });
    connect(menu->addAction(Words::tr("A file…")), &QAction::triggered, this,
            [this] { open(ways_.which_file); });
    menu->addSeparator();
    for (const BuiltInLesson& entry : built_in_lessons()) {
        QAction* action =
            menu->addAction(Words::tr("A copy of: %1").arg(translated(find_lesson(entry.id).name)));
        action->setObjectName(QString("beginWith_") + entry.id);
        connect(action, &QAction::triggered, this, [this, id = entry.id] { begin_with(id); });
    }
    begin->setMenu(menu);
    undo_ = add_button(*row, Words::tr("&Undo"), "lessonUndo", [this] { undo(); });
    redo_ = add_button(*row, Words::tr("Red&o"), "lessonRedo", [this] { redo(); });
    row->addStretch(1);
    add_button(*row, Words::tr("&Try it"), "lessonTry", [this] { try_out(); });
    add_button(*row, Words::tr("Sa&ve"), "lessonSave", [this] { save(false); });
    add_button(*row, Words::tr("Save &as…"), "lessonSaveAs", [this] { save(true); });
    add_button(*row, Words::tr("&Close"), "lessonClose", [this] { hide(); });
}

// A text field with typed changes undoes those first.
void LessonEditor::build_keys() {
    const auto key = [this](QKeySequence::StandardKey keys, void (LessonEditor::*run)()) {
        connect(new QShortcut(keys, this), &QShortcut::activated, this, run);
    };
    key(QKeySequence::Undo, &LessonEditor::undo);
    key(QKeySequence::Redo, &LessonEditor::redo);
    connect(new QShortcut(Qt::Key_Escape, this), &QShortcut::activated, this, [this] { hide(); });
    connect(new QShortcut(QKeySequence::Save, this), &QShortcut::activated, this,
            [this] { save(false); });
}

void LessonEditor::undo() {
    take_what_is_typed();
    document_.undo();
    changed(true);
}

void LessonEditor::redo() {
    take_what_is_typed();
    document_.redo();
    changed(true);
}

void LessonEditor::show_editor() {
    // Placed over the panels at the right, so that the vessels stay visible and clickable.
    const QWidget* window = isVisible() ? nullptr : parentWidget();
    aside_ = false;
    show();
    changed(true);  // the messages determine the minimum size
    if (window != nullptr) {
        constexpr int title = 40;
        place_on_screen(*this, window->mapToGlobal(QPoint(window->width() - width(), title)),
                        title);
    }
    raise();
    activateWindow();
}

// A place that was waited for belonged to what was shown before.
void LessonEditor::show_page() {
    places_->wait_no_more();
    shown_pages_[static_cast<std::size_t>(pages_->currentIndex())]->show_lesson(document_.lesson());
}

void LessonEditor::changed(bool shape) {
    if (shape) show_page();
    show_state();
    keep_->start();
    ways_.places_changed();
}

void LessonEditor::show_state() {
    const QString file = document_.file().empty() ? Words::tr("not saved yet")
                                                  : to_text(document_.file().filename());
    setWindowTitle(Words::tr("%1[*] (%2) - Lesson editor")
                       .arg(QString::fromStdString(document_.lesson().name), file));
    setWindowModified(document_.dirty());
    const QString left =
        document_.left_behind()
            ? Words::tr("This lesson was left unsaved by an earlier run of the program.") + "\n"
            : "";
    doubts_->setText(
        left + doubts_in_words(document_.lesson(), ways_.patient().get(), ways_.shown_patient()));
    doubts_->setVisible(!doubts_->text().isEmpty());
    const std::shared_ptr<const PatientCase> own = own_patient();
    accept_->setVisible(own && !misfits(document_.lesson(), own->tree).empty());
    undo_->setEnabled(document_.can_undo());
    redo_->setEnabled(document_.can_redo());
}

void LessonEditor::patient_shown() {
    if (isVisible()) {
        show_page();  // offers the new patient
        show_state();
    }
    if (isVisible() || aside_) ways_.places_changed();  // they lie on other vessels
}

void LessonEditor::tumours_changed() {
    places_->offer_tumours();
}

void LessonEditor::keep_now() {
    keep_->stop();
    attempt(Words::tr("Keep the unsaved lesson"), [this] { document_.keep_copy(); });
}

void LessonEditor::attempt(const QString& doing, const std::function<void()>& task) {
    try {
        task();
    } catch (...) {
        ways_.failed(doing, std::current_exception());
    }
}

// A field reports its text when it loses the focus, which pressing a button by its key does not
// cause.
void LessonEditor::take_what_is_typed() {
    QWidget* field = QApplication::focusWidget();
    if (field != nullptr && isAncestorOf(field)) field->clearFocus();
}

bool LessonEditor::may_end() {
    take_what_is_typed();
    keep_now();
    return may_leave(document_.kept());
}

bool LessonEditor::may_leave(bool kept) {
    if (!document_.dirty()) return true;
    switch (ways_.unsaved(kept)) {
        case UnsavedLesson::save:
            save(false);
            return !document_.dirty();
        case UnsavedLesson::keep:
            return true;
        case UnsavedLesson::discard:
            document_.let_go();
            return true;
        case UnsavedLesson::stay:
            break;
    }
    return false;
}

void LessonEditor::begin_with(const std::string& id) {
    take_what_is_typed();
    if (!may_leave(false)) return;
    document_.begin(id.empty() ? new_lesson_in_words() : built_in_lesson_in_words(id));
    about_->forget();
    changed(true);
}

void LessonEditor::edit(const std::filesystem::path& file) {
    if (document_.file() != file) open([&file] { return std::optional(file); });
    pages_->setCurrentIndex(1);  // the page of places
    show_editor();
}

std::shared_ptr<const PatientCase> LessonEditor::own_patient() const {
    const Lesson& lesson = document_.lesson();
    const bool own = can_be_tied(lesson) && is_for_shown(lesson, ways_.shown_patient());
    return own ? ways_.patient() : nullptr;
}

void LessonEditor::accept_places() {
    const std::shared_ptr<const PatientCase> own = own_patient();
    if (own == nullptr) return;
    document_.change("", [&own](Lesson& lesson) {
        untie(lesson);
        tie(lesson, own->tree);
    });
    changed(true);
}

void LessonEditor::open(const std::function<std::optional<std::filesystem::path>()>& which) {
    take_what_is_typed();
    if (!may_leave(false)) return;
    const auto file = which();
    if (!file) return;
    attempt(Words::tr("Open lesson"), [&] {
        document_.open(*file);
        about_->forget();
    });
    changed(true);
}

void LessonEditor::save(bool ask) {
    take_what_is_typed();
    std::optional<std::filesystem::path> file = document_.file();
    if (ask || file->empty())
        file = ways_.where_to_save(QString::fromStdString(document_.lesson().name));
    if (!file) return;
    attempt(Words::tr("Save lesson"), [&] {
        refuse_gaps(document_.lesson(), Words::id("This lesson cannot be saved yet"));
        if (const auto own = own_patient()) document_.tie(own->tree);
        document_.save(*file);
    });
    show_state();
}

void LessonEditor::try_out() {
    take_what_is_typed();
    keep_now();
    bool whole = false;
    attempt(Words::tr("Try the lesson"), [&] {
        refuse_gaps(document_.lesson(), Words::id("This lesson cannot be tried yet"));
        lesson_of(text_of(document_.lesson()), Words::id("This lesson"));
        whole = true;
    });
    if (!whole) return;  // the messages say what is wrong, and the editor stays open
    trying_ = true;
    hide();
    if (!ways_.try_out(document_.lesson())) back_from_trying();
}

void LessonEditor::back_from_trying() {
    if (std::exchange(trying_, false)) show_editor();
}

void LessonEditor::place_clicked(const Vec3& place_mm) {
    places_->place_clicked(place_mm);
    come_back();
}

void LessonEditor::step_aside() {
    aside_ = true;
    hide();
}

void LessonEditor::come_back() {
    if (!std::exchange(aside_, false)) return;
    places_->wait_no_more();
    show();
    raise();
    activateWindow();
}

std::vector<TumourPlace> LessonEditor::targets() const {
    std::vector<TumourPlace> targets;
    const std::shared_ptr<const PatientCase> patient = ways_.patient();
    if (patient == nullptr || patient->tree.segments.empty()) return targets;
    for (const Tumour& tumour : ways_.tumours()) {
        const Vec3 from_mm = place_that_feeds(patient->tree, tumour.middle_mm);
        targets.push_back(
            {tumour.number, tumour.volume_ml, from_mm, (from_mm - tumour.middle_mm).norm()});
    }
    return targets;
}

std::shared_ptr<const PatientCase> LessonEditor::patient_of_places() const {
    return isVisible() || aside_ ? ways_.patient() : nullptr;
}

std::vector<Vec3> LessonEditor::places() const {
    std::vector<Vec3> places;
    const std::shared_ptr<const PatientCase> patient = patient_of_places();
    if (patient == nullptr) return places;
    for (const LessonMark& mark : document_.lesson().marks)
        places.push_back(place_on(patient->tree, mark.place));
    if (const auto target = target_mm()) places.push_back(*target);
    return places;
}

bool LessonEditor::is_hidden(const ScriptPlace& place) const {
    const std::shared_ptr<const PatientCase> patient = patient_of_places();
    return patient != nullptr && ways_.is_hidden(place_on(patient->tree, place));
}

std::optional<Vec3> LessonEditor::target_mm() const {
    const std::optional<ScriptPlace>& target = document_.lesson().target;
    const std::shared_ptr<const PatientCase> patient = patient_of_places();
    if (patient == nullptr || !target) return std::nullopt;
    return place_on(patient->tree, *target);
}

void LessonEditor::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    if (aside_) return;
    places_->wait_no_more();
    keep_now();
    ways_.places_changed();
}

}  // namespace hepatica
