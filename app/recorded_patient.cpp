// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recorded_patient.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <vector>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/opening/open_patient.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> cases_beside(const fs::path& file) {
    std::vector<fs::path> cases;
    for (const fs::directory_entry& entry :
         fs::directory_iterator(fs::absolute(file).parent_path()))
        if (is_case(entry.path())) cases.push_back(entry.path());
    std::ranges::sort(cases);
    return cases;
}

}  // namespace

PatientCase recorded_patient(const Recording& recording, const fs::path& file,
                             const fs::path& given, const BuiltInCache* built_in, Job& job) {
    if (!given.empty()) return read_case_without_voxels(given);
    for (const fs::path& folder : cases_beside(file)) {
        job.throw_if_cancelled();
        try {
            PatientCase patient = read_case_without_voxels(folder);
            if (hash_of(patient) == recording.patient_hash) return patient;
        } catch (const InputError& error) {
            spdlog::warn("{} is passed over: {}", folder.string(), error.problem());
        }
    }
    if (built_in != nullptr) {
        OpenRequest request;
        request.built_in = true;
        request.cache = *built_in;
        const OpenedPatient opened = open_patient(request, job);
        if (hash_of(*opened.patient) == recording.patient_hash) return *opened.patient;
    }
    throw InputError("no case beside it has the patient that was recorded, whose hash is " +
                         to_hex(recording.patient_hash),
                     file.string(), "Name the case: --patient CASE");
}

}  // namespace hepatica
