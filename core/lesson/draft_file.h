// SPDX-License-Identifier: GPL-3.0-or-later
// The editor's copy of an unsaved lesson, finished or not, with the file that it came from.
//   {"format": "hepatica-lesson-draft", "version": 1, "file": "/home/me/lesson.json",
//    "patient_in_file": "../a.hep", "patient_path": "/home/a.hep", "lesson": {...}}
#pragma once

#include <filesystem>
#include <string>

#include "core/lesson/lesson.h"

namespace hepatica {

struct LessonDraft {
    Lesson lesson;               // may have gaps, see lesson_gaps.h
    std::filesystem::path file;  // of the lesson; empty: not saved yet
    // The patient as written in that file, and the path resolved from it; may be empty.
    std::string patient_in_file, patient_path;
};

std::string text_of(const LessonDraft& draft);
// Throws InputError with `place` as the file. Also reads the text of a lesson, which earlier
// versions stored; the other fields are then empty.
LessonDraft draft_of(const std::string& text, const std::string& place);

}  // namespace hepatica
