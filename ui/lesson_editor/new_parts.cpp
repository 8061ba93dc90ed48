// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_editor/new_parts.h"

#include <algorithm>

#include "core/lesson/lesson_draft.h"
#include "core/lesson/lesson_file.h"
#include "ui/core_words.h"

namespace hepatica {
namespace {

void say(std::string& text) {
    text = translated(text).toStdString();
}

Lesson in_words(Lesson lesson) {
    say(lesson.name);
    say(lesson.about);
    for (LessonMark& mark : lesson.marks) say(mark.name);
    for (LessonStep& step : lesson.steps) {
        say(step.text);
        say(step.hint);
    }
    return lesson;
}

}  // namespace

Lesson new_lesson_in_words() {
    return in_words(new_lesson());
}

Lesson built_in_lesson_in_words(const std::string& id) {
    return in_words(find_lesson(id));
}

LessonStep new_step_in_words() {
    LessonStep step = new_step();
    say(step.text);
    return step;
}

std::string free_mark_name_in_words(const Lesson& lesson) {
    for (int number = 1;; ++number) {
        std::string name = "mark " + std::to_string(number);
        say(name);
        if (std::ranges::find(lesson.marks, name, &LessonMark::name) == lesson.marks.end())
            return name;
    }
}

}  // namespace hepatica
