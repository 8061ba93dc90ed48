// SPDX-License-Identifier: GPL-3.0-or-later
// What tests of the editor of lessons share: an editor by itself, its ways, and its fields by name.
#pragma once

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <stdexcept>

#include "core/base/temporary_folder.h"
#include "core/base/text_file.h"
#include "core/lesson/draft_file.h"
#include "core/lesson/lesson_draft.h"
#include "core/lesson/lesson_file.h"
#include "tests/session/small_patient.h"
#include "tests/ui/window_test.h"
#include "ui/lesson_editor/lesson_editor.h"
#include "ui/paths.h"

namespace hepatica::testing {

class LessonEditorTest : public ::testing::Test {
  protected:
    LessonEditorTest() : editor_(ways(), folder_.path() / "unsaved.json", nullptr) {
        editor_.show_editor();
    }
    LessonEditor::Ways ways() {
        LessonEditor::Ways ways;
        ways.patient = [this] { return patient_; };
        ways.shown_patient = [this] { return shown_; };
        ways.ask_for_place = [this] { ++asked_for_place_; };
        ways.ask_no_more = [this] { ++asked_no_more_; };
        ways.places_changed = [this] { drawn_ = editor_.places(); };
        ways.try_out = [this](const Lesson& lesson) {
            tried_ = lesson;
            return can_try_;
        };
        ways.which_file = [this] { return file_; };
        ways.where_to_save = [this](const QString&) { return file_; };
        ways.unsaved = [this](bool kept) {
            asked_kept_ = kept;
            return answer_;
        };
        ways.failed = [this](const QString&, const std::exception_ptr&) { ++failures_; };
        ways.tumours = [this] { return tumours_; };
        ways.is_hidden = [this](const Vec3& place) { return hides_ && hides_(place); };
        return ways;
    }
    const Lesson& lesson() { return editor_.document().lesson(); }
    // The case that is shown lies in a folder, else the editor doubts that it is there.
    QString folder_of(const char* name) {
        std::filesystem::create_directory(folder_.path() / name);
        return to_text(folder_.path() / name);
    }
    // On the centreline of the patient who is shown, to a tenth.
    Vec3 on_vessel(std::size_t segment) {
        const Vec3& at = patient_->tree.segments.at(segment).points_mm.at(1);
        return (10.0 * at).array().round() / 10.0;
    }
    template <class T>
    T& field(const QString& name) {
        T* found = editor_.findChild<T*>(name);
        if (found == nullptr) throw std::runtime_error("no field " + name.toStdString());
        return *found;
    }
    void click(const QString& name) { field<QPushButton>(name).click(); }
    void turn_to(int page) { field<QTabWidget>("lessonPages").setCurrentIndex(page); }
    void choose(const QString& name, int item) {
        auto& box = field<QComboBox>(name);
        box.setCurrentIndex(item);
        emit box.activated(item);
    }
    // What is on disk of it.
    Lesson kept() {
        return draft_of(read_text_file(folder_.path() / "unsaved.json", ""), "copy").lesson;
    }
    QString doubts() {
        auto& label = field<QLabel>("lessonDoubts");
        return label.isVisible() ? label.text() : "";
    }

    TemporaryFolder folder_;
    std::shared_ptr<const PatientCase> patient_ = test::small_patient();
    std::optional<std::filesystem::path> file_ = folder_.path() / "made.json";
    std::optional<Lesson> tried_;
    UnsavedLesson answer_ = UnsavedLesson::stay;
    std::optional<bool> asked_kept_;  // whether there was a copy when it was asked
    bool can_try_ = true;
    QString shown_ = folder_of("shown.hep");
    int asked_for_place_ = 0, asked_no_more_ = 0, failures_ = 0;
    std::vector<Vec3> drawn_;
    std::vector<Tumour> tumours_;  // of the patient who is shown
    std::function<bool(const Vec3& place)> hides_;
    LessonEditor editor_;
};

}  // namespace hepatica::testing
