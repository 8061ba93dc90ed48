// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/play_notes.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/base/text_file.h"
#include "core/lesson/lesson_fields.h"

namespace hepatica {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr const char* notes_format = "hepatica-notes";
constexpr const char* notes_remedy = "Mend the file, or remove it: it holds notes alone";

PlayNote note_from(const LessonFields& fields) {
    fields.know({"at_s", "text"});
    const LessonFields at = fields.need("at_s");
    if (at.number() < 0.0)
        at.refuse("is " + at.dump() + ", before the beginning", "Give 0 or more");
    return {at.number(), fields.need("text").text()};
}

}  // namespace

fs::path notes_file_of(const fs::path& recording) {
    fs::path file = recording;
    return file.replace_extension(".notes.json");
}

std::vector<PlayNote> notes_of(const std::string& text, const std::string& place) {
    const Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) throw InputError("is not JSON", place, notes_remedy);
    const LessonFields fields(json, place, "");
    fields.know({"format", "version", "notes"});
    fields.require_format(notes_format, notes_remedy);
    std::vector<PlayNote> notes;
    for (const LessonFields& note : fields.need("notes").list()) notes.push_back(note_from(note));
    std::ranges::stable_sort(notes, {}, &PlayNote::at_s);
    return notes;
}

std::vector<PlayNote> read_notes(const fs::path& recording) {
    const fs::path file = notes_file_of(recording);
    if (!fs::exists(file)) return {};
    return notes_of(read_text_file(file, notes_remedy), file.string());
}

void write_notes(const fs::path& recording, const std::vector<PlayNote>& notes) {
    const fs::path file = notes_file_of(recording);
    if (notes.empty()) {
        std::error_code failed;
        fs::remove(file, failed);
        if (failed)
            throw InputError("cannot be removed: " + failed.message(), file.string(),
                             "Remove it by hand");
        return;
    }
    Json list = Json::array();
    for (const PlayNote& note : notes) list.push_back({{"at_s", note.at_s}, {"text", note.text}});
    write_text_atomically(
        file, Json{{"format", notes_format}, {"version", 1}, {"notes", list}}.dump(1) + "\n");
}

}  // namespace hepatica
