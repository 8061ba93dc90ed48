// SPDX-License-Identifier: GPL-3.0-or-later
// The lesson that is being edited: its undo history, its file, and a copy of unsaved changes that
// survives a crash. No widgets; not thread-safe.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/lesson/lesson.h"
#include "core/lesson/lesson_ties.h"
#include "core/lesson/lesson_writer.h"

namespace hepatica {

class LessonDocument {
  public:
    // `kept_copy` is the file of the unsaved copy; empty: none is kept. Starts with the copy left
    // by an earlier run and its file, else with a new lesson.
    explicit LessonDocument(std::filesystem::path kept_copy);

    const Lesson& lesson() const { return states_[now_]; }
    // Where it was opened from or saved to; empty if nowhere yet.
    const std::filesystem::path& file() const { return file_; }
    // Whether the lesson differs from its file, or from the lesson it began with.
    bool dirty() const;
    // Whether it is the unsaved lesson of an earlier run.
    bool left_behind() const { return left_behind_; }

    // Replaces the lesson and forgets its history.
    void begin(Lesson lesson);
    // Throws as read_lesson() does. A relative path to the patient is made absolute.
    void open(const std::filesystem::path& file);

    // Consecutive changes with the same `field`, as by typing, are undone together; those with an
    // empty `field` one by one. Returns false if nothing differs afterwards.
    bool change(const std::string& field, const std::function<void(Lesson&)>& change);
    bool can_undo() const { return now_ > 0; }
    bool can_redo() const { return now_ + 1 < states_.size(); }
    void undo();
    void redo();

    // Ties its places to the patient's vessels where they are not tied yet (lesson_ties.h). Not
    // part of the undo history.
    void tie(const VesselTree& tree) { hepatica::tie(states_[now_], tree); }
    // Throws as write_lesson() does. A patient in the file's folder or below is named relative to
    // it.
    void save(const std::filesystem::path& file);
    // Writes the copy if something is unsaved, else removes it. Throws InputError if it cannot be
    // written.
    void keep_copy();
    // Removes the copy; the unsaved changes will not be offered at the next start.
    void let_go();
    // Whether the copy on disk equals the present lesson.
    bool kept() const { return kept_text_ == text_of(lesson()); }

  private:
    void forget_states(Lesson lesson);
    void give_id(const std::string& id);
    std::string name_in_file() const;
    std::string id_in(const std::filesystem::path& file) const;

    std::filesystem::path kept_copy_;
    std::filesystem::path file_;
    std::vector<Lesson> states_;
    std::size_t now_ = 0;
    std::string field_;  // of the last change
    std::string saved_text_;
    std::string kept_text_;
    // The patient as the file names him, and the absolute path made from that.
    std::string patient_in_file_, patient_path_;
    bool left_behind_ = false;
};

}  // namespace hepatica
