// SPDX-License-Identifier: GPL-3.0-or-later
// Lessons are made and changed here, beside the window: pages of what a lesson says and asks, what
// can hardly be meant in words, undo, a play to try it, and its file.
#pragma once

#include <QWidget>
#include <functional>
#include <memory>
#include <optional>

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

// What becomes of changes that are not saved: saved, left in their copy for the next start, let go,
// or the program stays where it is.
enum class UnsavedLesson { save, keep, discard, stay };

// UI thread. A window of its own, but no QDialog: Enter in a field presses no button.
class LessonEditor : public QWidget {
  public:
    struct Ways {
        // The patient that is shown, null: none; and as a lesson names him: "built-in" or the
        // folder of his case, empty: he lies nowhere.
        std::function<std::shared_ptr<const PatientCase>()> patient;
        std::function<QString()> shown_patient;
        // The next click on a vessel is for place_clicked(), or is not any more.
        std::function<void()> ask_for_place, ask_no_more;
        // places() are others now.
        std::function<void()> places_changed;
        // Plays it, or opens its patient to do so; the editor comes back by back_from_trying().
        // False: not after all.
        std::function<bool(const Lesson&)> try_out;
        // A file to open, or to save under the name that is suggested; none: not after all.
        std::function<std::optional<std::filesystem::path>()> which_file;
        std::function<std::optional<std::filesystem::path>(const QString& suggested)> where_to_save;
        // What is to become of changes that are not saved, which have a copy on disk or not.
        std::function<UnsavedLesson(bool kept)> unsaved;
        std::function<void(const QString& doing, const std::exception_ptr& error)> failed;
    };
    // See LessonDocument about the copy.
    LessonEditor(Ways ways, std::filesystem::path kept_copy, QWidget* parent);
    ~LessonEditor() override;

    // Shows the lesson where it was left.
    void show_editor();
    // Shows the places of this one, unless what is not saved of another one keeps that here.
    void edit(const std::filesystem::path& file);
    // On the centreline, undeformed.
    void place_clicked(const Vec3& place_mm);
    // Off the vessels that it covers, until come_back(): a place is waited for.
    void step_aside();
    void come_back();
    // Of the marks and the target on the patient that is shown, undeformed; none while hidden.
    std::vector<Vec3> places() const;
    void back_from_trying();
    // There is another patient now, or there are other vessels of his.
    void patient_shown();
    // Before the program ends: changes that are not saved are asked about.
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
    // Before another lesson takes its place, or the program ends.
    bool may_leave(bool kept);
    void changed(bool shape);
    void show_page();
    void show_state();
    void keep_now();
    void begin_with(const std::string& id);  // empty: a new one
    void open(const std::function<std::optional<std::filesystem::path>()>& which);
    // Who is shown, where he is the patient of this lesson and of no other; else null.
    std::shared_ptr<const PatientCase> own_patient() const;
    void accept_places();
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
