// SPDX-License-Identifier: GPL-3.0-or-later
// The lessons and the course that are compiled into the program, see lesson_file.h.
#include <array>

#include "core/lesson/lesson_file.h"

namespace hepatica {

namespace {

// The course, then its lessons; CMake generates the list from assets/lessons.
constexpr BuiltInLesson texts[] = {
#include "built_in_lesson_texts.inc"
};

}  // namespace

std::vector<BuiltInLesson> built_in_lessons() {
    return {std::begin(texts) + 1, std::end(texts)};
}

const char* built_in_course() {
    return texts[0].text;
}

}  // namespace hepatica
