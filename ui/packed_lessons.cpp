// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/packed_lessons.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/base/flush_to_disk.h"
#include "core/base/temporary_folder.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_writer.h"
#include "core/patient/case_archive.h"
#include "ui/file_name.h"
#include "ui/paths.h"
#include "ui/shelved_lessons.h"
#include "ui/words.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_lessons = 40;  // an archive holds 64 files, of which a case needs some
constexpr const char* of_its_folder = ".";

fs::path file_of(const fs::path& folder, std::size_t number) {
    return folder / ("lesson-" + std::to_string(number) + ".json");
}

// "Gentle pull.json" in the folder, or the first free name after it.
fs::path free_file(const fs::path& folder, const std::string& name) {
    const QString stem = as_file_name(QString::fromStdString(name), "lesson");
    fs::path file = folder / to_path(stem + ".json");
    for (int number = 2; fs::exists(file); ++number)
        file = folder / to_path(QString("%1 %2.json").arg(stem, QString::number(number)));
    return file;
}

void require_room_for(const std::vector<Lesson>& lessons, const fs::path& archive) {
    if (lessons.size() > most_lessons)
        throw InputError(
            Words::id("cannot hold all lessons for this patient: they are more than 40"),
            archive.string(), Words::id("Put lessons that are not needed into another folder"));
}

}  // namespace

bool holds_lessons(const fs::path& archive) {
    if (!is_case_archive(archive)) return false;
    for (std::size_t number = 1; number <= most_lessons; ++number)
        if (archive_holds(archive, file_of({}, number).c_str())) return true;
    return false;
}

std::vector<Lesson> lessons_in_archive(const fs::path& archive) {
    std::vector<Lesson> lessons;
    if (!is_case_archive(archive)) return lessons;
    const TemporaryFolder folder;
    unpack_case(archive, folder.path());
    for (std::size_t number = 1; number <= most_lessons; ++number) {
        std::error_code ignored;
        if (!fs::exists(file_of(folder.path(), number), ignored)) continue;
        try {
            lessons.push_back(read_lesson(file_of(folder.path(), number)));
        } catch (const InputError&) {
            continue;  // the case is none the worse for it
        }
    }
    return lessons;
}

std::vector<Lesson> lessons_not_beside(const fs::path& archive, Job& job) {
    std::vector<Lesson> lessons = lessons_in_archive(archive);
    if (lessons.empty()) return lessons;
    std::vector<ShelvedLesson> beside;
    try {
        beside = lessons_of(lessons_in(archive.parent_path(), job), archive);
    } catch (const InputError&) {
        return lessons;  // nothing is known of the folder
    }
    std::erase_if(beside, [](const ShelvedLesson& lesson) {
        return lesson.patient != ShelvedLesson::Patient::this_case;
    });
    std::erase_if(lessons, [&](const Lesson& lesson) {
        return std::ranges::find(beside, QString::fromStdString(lesson.name),
                                 &ShelvedLesson::name) != beside.end();
    });
    return lessons;
}

void require_place_of_file(const fs::path& archive) {
    require_no_folder_at(archive);
    require_place_of_case(archive);
}

void pack_lessons(const std::vector<Lesson>& lessons, const fs::path& archive) {
    if (lessons.empty()) return;
    require_room_for(lessons, archive);
    const TemporaryFolder folder;
    unpack_case(archive, folder.path());
    for (std::size_t i = 0; i < lessons.size(); ++i) {
        Lesson lesson = lessons[i];
        lesson.patient = of_its_folder;
        write_lesson(file_of(folder.path(), i + 1), lesson);
    }
    pack_case(folder.path(), archive);
}

void write_with_lessons(const fs::path& archive, const PatientCase& patient,
                        const std::vector<Lesson>& lessons) {
    require_place_of_file(archive);
    require_room_for(lessons, archive);
    const TemporaryFolder folder;
    const fs::path made = folder.path() / "case.hepz";
    write_case(made, patient);
    pack_lessons(lessons, made);
    write_file_atomically(archive, [&](const fs::path& temporary) {
        fs::copy_file(made, temporary, fs::copy_options::overwrite_existing);
        flush_to_disk(temporary, archive);
    });
}

std::vector<fs::path> put_beside(const std::vector<Lesson>& lessons, const fs::path& place) {
    std::vector<fs::path> files;
    for (Lesson lesson : lessons) {
        lesson.patient = place.filename().string();
        files.push_back(free_file(place.parent_path(), lesson.name));
        write_lesson(files.back(), lesson);
    }
    return files;
}

}  // namespace hepatica
