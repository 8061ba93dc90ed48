// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/draft_file.h"

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/lesson/lesson_fields.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_writer.h"

namespace hepatica {

using Json = nlohmann::ordered_json;

namespace {

constexpr const char* draft_format = "hepatica-lesson-draft";
constexpr const char* draft_remedy = "Begin with a lesson that is whole";

}  // namespace

std::string text_of(const LessonDraft& draft) {
    const Json json{{"format", draft_format},
                    {"version", 1},
                    {"file", draft.file.string()},
                    {"patient_in_file", draft.patient_in_file},
                    {"patient_path", draft.patient_path},
                    {"lesson", Json::parse(text_of(draft.lesson))}};
    return json.dump(2) + "\n";
}

LessonDraft draft_of(const std::string& text, const std::string& place) {
    const Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) throw InputError("is not JSON", place, draft_remedy);
    const LessonFields fields(json, place, "", true);
    if (fields.has("steps")) return {unfinished_lesson_of(text, place), {}, {}, {}};
    fields.require_format(draft_format, draft_remedy);
    fields.know({"format", "version", "file", "patient_in_file", "patient_path", "lesson"});
    return {unfinished_lesson_of(fields.need("lesson").dump(), place), fields.need("file").text(),
            fields.need("patient_in_file").text(), fields.need("patient_path").text()};
}

}  // namespace hepatica
