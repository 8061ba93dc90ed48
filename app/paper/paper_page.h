// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's results made anew on one patient, as a page: its three figures and its contact
// points, ours beside what the paper prints.
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/job.h"
#include "core/patient/patient_case.h"
#include "core/session/script.h"
#include "core/study/contact_study.h"

namespace hepatica {

struct PaperOptions {
    std::string title;  // what the page calls the patient
    Script cut_line;    // of Fig. 3, see play_tear_figure
    ContactStudyOptions contact;
};

inline constexpr int paper_stage_count = 8;

// Writes index.html and its pictures into `folder`, which must exist; gives the page's figures.
// `patient` has its voxels. Throws InputError for a case without skeleton or body, Cancelled.
nlohmann::ordered_json write_paper(const std::shared_ptr<const PatientCase>& patient,
                                   const std::filesystem::path& folder, const PaperOptions& options,
                                   Job& job);

}  // namespace hepatica
