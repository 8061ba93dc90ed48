// SPDX-License-Identifier: GPL-3.0-or-later
// Window that edits lessons: pages for what a lesson says and asks, messages on what is missing or
// doubtful, undo, a trial play, and the lesson's file.
#pragma once

#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/patient/painted_tumours.h"
#include "core/patient/patient_case.h"
#include "ui/lesson_editor/lesson_document.h"

class QLabel;
class QPushButton;
class QTabWidget;
class QTimer;

namespace hepatica {

class AboutPage;
class LessonPage;
class PlacesPage;
struct TumourPlace;

// What to do with unsaved changes: save them, leave them in their copy for the next start, discard
// them, or cancel.
enum class UnsavedLesson { save, keep, discard, stay };

// UI thread only. A window of its own, but not a QDialog, so that Enter in a field presses no
// button.
class LessonEditor : public QWidget {
  public:
    struct Ways {
        // The shown patient, null for none, and his name in a lesson: "built-in" or the folder of
        // his case; empty if he has no place on disk.
        std::function<std::shared_ptr<const PatientCase>()> patient;
        std::function<QString()> shown_patient;
        // Starts or stops sending the next click on a vessel to place_clicked().
        std::function<void()> ask_for_place, ask_no_more;
        // places() or target_mm() has changed, or others are shown.
        std::function<void()> places_changed;
        // Plays the lesson, opening its patient if need be; back_from_trying() shows the editor
        // again. Returns false if cancelled.
        std::function<bool(const Lesson&)> try_out;
        // Asks for a file to open, or to save under the suggested name. nullopt: cancelled.
        std::function<std::optional<std::filesystem::path>()> which_file;
        std::function<std::optional<std::filesystem::path>(const QString& suggested)> where_to_save;
        // Asks what to do with unsaved changes; `kept`: they have a copy on disk.
        std::function<UnsavedLesson(bool kept)> unsaved;
        std::function<void(const QString& doing, const std::exception_ptr& error)> failed;
        // The shown patient's tumours, as far as they were read.
        std::function<std::vector<Tumour>()> tumours = [] { return std::vector<Tumour>(); };
        // Whether another vessel hides this place of the shown patient, mm.
        std::function<bool(const Vec3& place_mm)> is_hidden = [](const Vec3&) { return false; };
    };
    // `kept_copy`: see LessonDocument.
    LessonEditor(Ways ways, std::filesystem::path kept_copy, QWidget* parent);
    ~LessonEditor() override;

    // Shows the lesson where the user left it.
    void show_editor();
    // Opens this file and shows its places. If the user keeps unsaved changes of another lesson,
    // that lesson stays.
    void edit(const std::filesystem::path& file);
    // `place_mm`: on the centreline of the undeformed vessels, mm.
    void place_clicked(const Vec3& place_mm);
    // Hides the editor until come_back(), so that the vessels below it can be clicked on.
    void step_aside();
    void come_back();
    // Marks and target on the shown patient's undeformed vessels, mm; empty while the editor is
    // hidden.
    std::vector<Vec3> places() const;
    // Likewise where the target begins; nullopt also where there is none.
    std::optional<Vec3> target_mm() const;
    void back_from_trying();
    // Another patient is shown, or his vessels have changed.
    void patient_shown();
    void tumours_changed();
    // Asks about unsaved changes before the program ends; false: the user wants to stay.
    bool may_end();
    const LessonDocument& document() const { return document_; }

  protected:
    void hideEvent(QHideEvent* event) override;

  private:
    void build();
    void build_buttons(QWidget& foot);
    void build_keys();
    void undo();
    void redo();
    // Asks about unsaved changes before another lesson is opened or the program ends.
    bool may_leave(bool kept);
    void changed(bool shape);
    void show_page();
    void show_state();
    void keep_now();
    void begin_with(const std::string& id);  // empty: a new lesson
    void open(const std::function<std::optional<std::filesystem::path>()>& which);
    // The shown patient if the lesson is for him alone, else null.
    std::shared_ptr<const PatientCase> own_patient() const;
    void accept_places();
    std::vector<TumourPlace> targets() const;
    // The patient whose vessels the places are on; null where none are to be seen.
    std::shared_ptr<const PatientCase> patient_of_places() const;
    bool is_hidden(const ScriptPlace& place) const;
    void save(bool ask);
    void try_out();
    void take_what_is_typed();
    QWidget* scrolled(LessonPage* page);
    void attempt(const QString& doing, const std::function<void()>& task);

    Ways ways_;
    LessonDocument document_;
    QTabWidget* pages_;
    AboutPage* about_ = nullptr;
    PlacesPage* places_ = nullptr;
    std::vector<LessonPage*> shown_pages_;  // in the order of the tabs
    QLabel* doubts_;
    QPushButton* accept_;
    QPushButton *undo_ = nullptr, *redo_ = nullptr;
    QTimer* keep_;
    bool trying_ = false;
    bool aside_ = false;
};

}  // namespace hepatica
