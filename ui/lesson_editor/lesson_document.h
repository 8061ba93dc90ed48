// SPDX-License-Identifier: GPL-3.0-or-later
// The lesson that is being edited: what of it can be undone, where it lies on disk, and a copy of
// what is not saved yet, which a crash leaves behind. No toolkit; not thread-safe.
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
    // `kept_copy`: the file of the unsaved copy; empty: none is kept. Begins with what an earlier
    // run left there, which knows its file, else with a new lesson.
    explicit LessonDocument(std::filesystem::path kept_copy);

    const Lesson& lesson() const { return states_[now_]; }
    // Where it was opened or saved; empty: nowhere yet.
    const std::filesystem::path& file() const { return file_; }
    bool dirty() const;
    // It is what an earlier run left unsaved.
    bool left_behind() const { return left_behind_; }

    // In place of the one before, which is forgotten. A patient that is a path is made absolute.
    void begin(Lesson lesson);
    void open(const std::filesystem::path& file);  // throws as read_lesson() does

    // Changes of the same field one after another, as by typing, are undone together; an empty
    // `field` is never joined with another. False where nothing is different afterwards.
    bool change(const std::string& field, const std::function<void(Lesson&)>& change);
    bool can_undo() const { return now_ > 0; }
    bool can_redo() const { return now_ + 1 < states_.size(); }
    void undo();
    void redo();

    // Ties its places to its patient's vessels where they are not yet, see lesson_ties.h. That is
    // no change to be undone.
    void tie(const VesselTree& tree) { hepatica::tie(states_[now_], tree); }
    // Throws as write_lesson() does. A patient beside the file or below it is named relative to it.
    void save(const std::filesystem::path& file);
    // Writes the copy where something is unsaved, and removes it where all is saved.
    // Throws InputError where that cannot be done.
    void keep_copy();
    // Removes the copy; the next start knows nothing of what was not saved.
    void let_go();
    // The copy is the lesson as it is now.
    bool kept() const { return kept_text_ == text_of(lesson()); }

  private:
    void forget_states(Lesson lesson);

    std::filesystem::path kept_copy_;
    std::filesystem::path file_;
    std::vector<Lesson> states_;
    std::size_t now_ = 0;
    std::string field_;  // of the last change
    std::string saved_text_;
    std::string kept_text_;
    // The patient as the file names him, and the path that was made of it.
    std::string patient_in_file_, patient_path_;
    bool left_behind_ = false;
};

}  // namespace hepatica
