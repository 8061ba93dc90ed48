// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shelved_lessons.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

#include "core/base/error.h"
#include "core/base/file_extension.h"
#include "core/base/text_file.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_ties.h"
#include "ui/core_words.h"
#include "ui/paths.h"
#include "ui/words.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

using Patient = ShelvedLesson::Patient;

// Bytes; larger JSON files, such as meshes, are no lessons.
constexpr std::uintmax_t longest_lesson = 1 << 20;

// Whether the file declares itself a lesson, readable or not, or fails to be read.
bool claims_to_be_lesson(const fs::path& file) {
    std::error_code failed;
    if (!fs::is_regular_file(file, failed) || fs::file_size(file, failed) > longest_lesson)
        return false;
    std::ifstream in(file, std::ios::binary);
    if (!in) return false;
    try {
        return read_text_stream(in, 0, file).find("\"hepatica-lesson\"") != std::string::npos;
    } catch (const InputError&) {
        return true;  // shelved() says why
    }
}

// nullopt for a lesson on the built-in patient, who is no case of a library.
std::optional<ShelvedLesson> shelved(const fs::path& file) {
    ShelvedLesson entry{file, to_text(file.filename()), {}, Patient::unreadable, {}};
    try {
        const Lesson lesson = read_lesson(file);
        if (lesson.patient == "built-in") return std::nullopt;
        entry.name = QString::fromStdString(lesson.name);
        entry.about = QString::fromStdString(lesson.about);
        entry.patient = Patient::any;
        if (lesson.patient != "any") {
            entry.patient = Patient::this_case;
            entry.of_case = file.parent_path() / lesson.patient;
        }
    } catch (const InputError& error) {
        entry.about = QString("%1: %2. %3")
                          .arg(translated(error.place()), translated(error.problem()),
                               translated(error.remedy()));
    }
    return entry;
}

}  // namespace

std::vector<ShelvedLesson> lessons_in(const fs::path& folder, Job& job) {
    std::vector<fs::path> files;
    std::error_code failed;
    for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end;
         entry.increment(failed))
        if (extension_of(entry->path()) == ".json") files.push_back(entry->path());
    if (failed && failed != std::errc::no_such_file_or_directory)
        throw InputError("cannot be read (" + failed.message() + ")", folder.string(),
                         Words::id("Choose another folder"));
    std::ranges::sort(files);
    std::vector<ShelvedLesson> lessons;
    for (const fs::path& file : files) {
        job.throw_if_cancelled();
        if (!claims_to_be_lesson(file)) continue;
        if (auto lesson = shelved(file)) lessons.push_back(*std::move(lesson));
    }
    for (const BuiltInLesson& entry : built_in_lessons()) {
        const Lesson lesson = find_lesson(entry.id);
        if (lesson.patient == "any")
            lessons.push_back({entry.id,
                               QString::fromStdString(lesson.name),
                               QString::fromStdString(lesson.about),
                               Patient::any,
                               {}});
    }
    return lessons;
}

std::vector<ShelvedLesson> lessons_of(const std::vector<ShelvedLesson>& all,
                                      const fs::path& place) {
    std::vector<ShelvedLesson> fitting;
    for (const Patient kind : {Patient::this_case, Patient::any, Patient::unreadable})
        for (const ShelvedLesson& lesson : all)
            if (lesson.patient == kind &&
                (kind != Patient::this_case || same_place(lesson.of_case, place)))
                fitting.push_back(lesson);
    return fitting;
}

void compare_with(const VesselTree& tree, const fs::path& place,
                  std::vector<ShelvedLesson>& lessons, const VesselTree* before) {
    for (ShelvedLesson& lesson : lessons) {
        if (lesson.patient != Patient::this_case || !same_place(lesson.of_case, place)) continue;
        try {
            Lesson own = read_lesson(lesson.file);
            if (before != nullptr) tie(own, *before);
            lesson.misfits = misfits(own, tree);
        } catch (const InputError&) {
            continue;  // being written, or removed
        }
    }
}

}  // namespace hepatica
