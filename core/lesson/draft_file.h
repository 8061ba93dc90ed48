// SPDX-License-Identifier: GPL-3.0-or-later
// The copy of a lesson that is not saved yet: the lesson, finished or not, and where it came from.
//   {"format": "hepatica-lesson-draft", "version": 1, "file": "/home/me/lesson.json",
//    "patient_in_file": "../a.hep", "patient_path": "/home/a.hep", "lesson": {...}}
#pragma once

#include <filesystem>
#include <string>

#include "core/lesson/lesson.h"

namespace hepatica {

struct LessonDraft {
    Lesson lesson;               // may have gaps, see lesson_gaps.h
    std::filesystem::path file;  // where it was opened or saved; empty: nowhere yet
    // The patient as that file names him, and the path that was made of it; may be empty.
    std::string patient_in_file, patient_path;
};

std::string text_of(const LessonDraft& draft);
// Throws InputError, with `place` for the file. Reads a lesson's own text too, as a draft of
// nowhere: so earlier programs left it.
LessonDraft draft_of(const std::string& text, const std::string& place);

}  // namespace hepatica
