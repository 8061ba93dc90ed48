// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_editor/lesson_document.h"

#include <utility>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/base/text_file.h"
#include "core/lesson/attempts.h"
#include "core/lesson/draft_file.h"
#include "core/lesson/lesson_draft.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_writer.h"
#include "ui/lesson_editor/new_parts.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

bool is_path(const std::string& patient) {
    return patient != "any" && patient != "built-in";
}

// Relative to the file's folder unless that would climb out of it.
std::string beside(const std::string& patient, const fs::path& file) {
    const fs::path relative = fs::path(patient).lexically_relative(file.parent_path());
    const bool climbs = relative.empty() || *relative.begin() == "..";
    return climbs ? patient : relative.string();
}

}  // namespace

LessonDocument::LessonDocument(fs::path kept_copy) : kept_copy_(std::move(kept_copy)) {
    if (!kept_copy_.empty() && fs::exists(kept_copy_)) {
        try {
            LessonDraft draft =
                draft_of(read_text_file(kept_copy_, "Begin anew"), kept_copy_.string());
            forget_states(std::move(draft.lesson));
            file_ = std::move(draft.file);
            patient_in_file_ = std::move(draft.patient_in_file);
            patient_path_ = std::move(draft.patient_path);
            left_behind_ = true;
            return;
        } catch (const InputError&) {
            // Written by another version of the program: renamed, not deleted.
            std::error_code ignored;
            fs::rename(kept_copy_, kept_copy_.string() + ".unreadable", ignored);
        }
    }
    begin(new_lesson_in_words());
}

void LessonDocument::forget_states(Lesson lesson) {
    states_ = {std::move(lesson)};
    now_ = 0;
    field_.clear();
    left_behind_ = false;
}

// In all states, so that undo does not take it away.
void LessonDocument::give_id(const std::string& id) {
    for (Lesson& state : states_) state.id = id;
    saved_text_ = text_of(lesson());
}

// What is edited may have been renamed before the program ended without saving it.
std::string LessonDocument::name_in_file() const {
    try {
        return read_lesson(file_).name;
    } catch (const InputError&) {
        return states_.front().name;
    }
}

// A lesson in another file is another one, and keeps its attempts apart. An older one without an id
// is known by the name that its attempts have.
std::string LessonDocument::id_in(const fs::path& file) const {
    if (file != file_) return new_lesson_id();
    if (!lesson().id.empty()) return lesson().id;
    const std::string before = name_in_file();
    return lesson().name != before ? id_of_former_name(before) : "";
}

void LessonDocument::begin(Lesson lesson) {
    lesson.id.clear();  // of whose copy this is
    saved_text_ = text_of(lesson);
    forget_states(std::move(lesson));
    file_.clear();
    patient_in_file_.clear();
    patient_path_.clear();
}

void LessonDocument::open(const fs::path& file) {
    const fs::path place = fs::absolute(file).lexically_normal();
    Lesson lesson = read_lesson(place);
    const std::string in_file = lesson.patient;
    if (is_path(lesson.patient))
        lesson.patient = (place.parent_path() / lesson.patient).lexically_normal().string();
    const std::string path = lesson.patient, id = lesson.id;
    begin(std::move(lesson));
    give_id(id);
    file_ = place;
    patient_in_file_ = in_file;
    patient_path_ = path;
}

bool LessonDocument::dirty() const {
    return text_of(lesson()) != saved_text_;
}

bool LessonDocument::change(const std::string& field, const std::function<void(Lesson&)>& change) {
    Lesson changed = lesson();
    change(changed);
    // The ties are to the former patient's vessels.
    if (changed.patient != lesson().patient) untie(changed);
    if (text_of(changed) == text_of(lesson())) return false;
    states_.resize(now_ + 1);
    const bool joins = now_ > 0 && !field.empty() && field == field_;
    if (!joins) {
        states_.emplace_back();
        ++now_;
    }
    states_[now_] = std::move(changed);
    field_ = field;
    return true;
}

void LessonDocument::undo() {
    if (can_undo()) --now_;
    field_.clear();
}

void LessonDocument::redo() {
    if (can_redo()) ++now_;
    field_.clear();
}

void LessonDocument::save(const fs::path& file) {
    const fs::path place = fs::absolute(file).lexically_normal();
    Lesson written = lesson();
    // An unchanged patient keeps the name that the file gave him: a course may lie beside its
    // cases.
    if (written.patient == patient_path_ && place.parent_path() == file_.parent_path())
        written.patient = patient_in_file_;
    else if (is_path(written.patient))
        written.patient = beside(written.patient, place);
    written.id = id_in(place);
    write_lesson(place, written);
    give_id(written.id);
    file_ = place;
    patient_in_file_ = written.patient;  // from here on that of this file, not of the one before
    patient_path_ = lesson().patient;
    left_behind_ = false;
    keep_copy();
}

void LessonDocument::keep_copy() {
    if (kept_copy_.empty()) return;
    std::error_code ignored;
    if (!dirty()) {
        fs::remove(kept_copy_, ignored);
        return;
    }
    fs::create_directories(kept_copy_.parent_path(), ignored);
    write_text_atomically(kept_copy_,
                          text_of(LessonDraft{lesson(), file_, patient_in_file_, patient_path_}));
    kept_text_ = text_of(lesson());
}

void LessonDocument::let_go() {
    std::error_code ignored;
    fs::remove(kept_copy_, ignored);
    kept_text_.clear();
}

}  // namespace hepatica
