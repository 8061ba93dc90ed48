// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's results on one patient as a page: its three figures and its table of contact points,
// ours beside the paper's.
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
    std::string title;  // name of the patient on the page
    Script cut_line;    // of Fig. 3, see play_tear_figure()
    ContactStudyOptions contact;
};

inline constexpr int paper_stage_count = 9;

// Writes index.html and its pictures into `folder`, which must exist, and returns the page's
// numbers. Begins paper_stage_count stages. `patient` must have its voxels. Throws InputError for a
// case without a skeleton or a body; Cancelled.
nlohmann::ordered_json write_paper(const std::shared_ptr<const PatientCase>& patient,
                                   const std::filesystem::path& folder, const PaperOptions& options,
                                   Job& job);

}  // namespace hepatica
