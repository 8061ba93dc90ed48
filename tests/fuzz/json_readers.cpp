// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "core/base/temporary_folder.h"
#include "core/lesson/attempts.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/play_notes.h"
#include "core/links/link_model.h"
#include "core/patient/case_archive.h"
#include "core/patient/measurement.h"
#include "core/patient/patient_case.h"
#include "core/scene/scene_spec.h"
#include "core/session/recording_file.h"
#include "core/session/script.h"
#include "core/tree/files/tree_io.h"
#include "tests/fuzz/input_file.h"
#include "tests/fuzz/readers.h"
#include "tests/fuzz/refuse_or.h"

namespace hepatica::fuzz {

namespace {

std::string text_of(Bytes bytes) {
    return {bytes.begin(), bytes.end()};
}

void read_json_tree(Bytes bytes) {
    const auto file = file_of(bytes, "tree.json");
    refuse_or([&] { validate(read_tree(file)); });
}

void read_recording_file(Bytes bytes) {
    const auto file = file_of(bytes, "session.hrec");
    refuse_or([&] { read_recording(file); });
}

void read_scene_file(Bytes bytes) {
    const auto file = file_of(bytes, "scene.json");
    refuse_or([&] { read_scene(file); });
}

void read_script_file(Bytes bytes) {
    const auto file = file_of(bytes, "script.json");
    refuse_or([&] { read_script(file); });
}

// The files that it names are missing, but for its own words.
void read_case_file(Bytes bytes) {
    const auto file = file_of(bytes, "case.hep/case.json");
    refuse_or([&] { read_case(file.parent_path()); });
}

void read_edits(Bytes bytes) {
    refuse_or([&] { edits_from_json(text_of(bytes), "corrections"); });
}

void read_bridges(Bytes bytes) {
    refuse_or([&] { bridges_from_json(text_of(bytes), "corrections"); });
}

// What can be read comes back from what is written of it.
void read_measurements(Bytes bytes) {
    refuse_or([&] {
        const auto measured = measurements_from_json(text_of(bytes), "measurements.json");
        const std::string text = measurements_to_json(measured);
        promise(measurements_from_json(text, "written") == measured, "the same measurements");
    });
}

// What can be read can be walked to its leaves.
void read_model(Bytes bytes) {
    const auto file = file_of(bytes, "links.json");
    refuse_or([&] { read_link_model(file).forest.share_of_vessel(PieceFeatures{}); });
}

void read_lesson_file(Bytes bytes) {
    refuse_or([&] { lesson_of(text_of(bytes), "lesson.json"); });
}

void read_course_file(Bytes bytes) {
    refuse_or([&] { course_of(text_of(bytes), "course.json"); });
}

void read_notes_file(Bytes bytes) {
    refuse_or([&] { notes_of(text_of(bytes), "play.notes.json"); });
}

void read_result_file(Bytes bytes) {
    refuse_or([&] { attempt_from(text_of(bytes), "play.hrec", "play.result.json"); });
}

void read_archive(Bytes bytes) {
    const auto file = file_of(bytes, "case.hepz");
    const TemporaryFolder folder;
    refuse_or([&] { unpack_case(file, folder.path()); });
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        promise(entry.is_regular_file(), "files and no folders");
}

constexpr Reader all[] = {{"tree_json", read_json_tree}, {"recording", read_recording_file},
                          {"scene", read_scene_file},    {"script", read_script_file},
                          {"case", read_case_file},      {"case_archive", read_archive},
                          {"edits", read_edits},         {"bridges", read_bridges},
                          {"lesson", read_lesson_file},  {"course", read_course_file},
                          {"notes", read_notes_file},    {"result", read_result_file},
                          {"links", read_model},         {"measurements", read_measurements}};

}  // namespace

std::span<const Reader> json_readers() {
    return all;
}

}  // namespace hepatica::fuzz
