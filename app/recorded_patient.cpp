// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recorded_patient.h"

#include <spdlog/spdlog.h>

#include <optional>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/opening/open_patient.h"
#include "core/opening/recorded_case.h"

namespace hepatica {

namespace fs = std::filesystem;

PatientCase recorded_patient(const Recording& recording, const fs::path& file,
                             const fs::path& given, const BuiltInCache* built_in,
                             int following_stages, Job& job) {
    std::optional<fs::path> place;
    if (!given.empty()) place = given;
    if (!place) {
        const CaseSearch search = case_beside(file, recording.patient_hash, job);
        for (const std::string& words : search.passed_over) spdlog::warn("{}", words);
        place = search.found;
    }
    if (place) {
        job.expect_stages(1 + following_stages);
        job.begin_stage("Reading the case");
        return read_case_without_voxels(*place);
    }
    if (built_in != nullptr) {
        OpenRequest request;
        request.built_in = true;
        request.cache = *built_in;
        job.expect_stages(opening_stage_count(request) + following_stages);
        const OpenedPatient opened = open_patient(request, job);
        if (hash_of(*opened.patient) == recording.patient_hash) {
            PatientCase patient = *opened.patient;
            if (patient.source.name.empty()) patient.source.name = built_in_title;
            return patient;
        }
    }
    throw InputError("no case beside it has the patient that was recorded, whose hash is " +
                         to_hex(recording.patient_hash),
                     file.string(), "Name the case: --patient CASE");
}

fs::path case_of_lesson(const Lesson& lesson, const std::string& lesson_file,
                        const fs::path& given) {
    const bool names_case = lesson.patient != "any" && lesson.patient != "built-in";
    if (!given.empty() || !names_case) return given;
    return fs::path(lesson_file).parent_path() / lesson.patient;
}

}  // namespace hepatica
