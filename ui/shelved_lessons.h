// SPDX-License-Identifier: GPL-3.0-or-later
// The lessons in a library's folder, and those of them that go with a case: for its patient, or for
// any. No widgets; made on a worker thread.
#pragma once

#include <QString>
#include <filesystem>
#include <vector>

#include "core/base/job.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

struct ShelvedLesson {
    enum class Patient { this_case, any, unreadable };

    std::filesystem::path file;
    QString name;   // of the lesson; if unreadable, of the file
    QString about;  // for the trainee; if unreadable, the reason
    Patient patient = Patient::any;
    std::filesystem::path of_case;  // the patient's case; empty if for any patient
    // Places of a lesson for this patient that no longer lie where they were on his vessels.
    std::vector<std::string> misfits{};
};

// The lessons directly in the folder, by file name, followed by the built-in ones for any patient.
// Other JSON files are skipped; a damaged lesson tells why. Throws Cancelled, and InputError if the
// folder exists but cannot be read.
std::vector<ShelvedLesson> lessons_in(const std::filesystem::path& folder, Job& job);

// The lessons that go with the case at `place`: its own, then those for any patient, then
// unreadable ones.
std::vector<ShelvedLesson> lessons_of(const std::vector<ShelvedLesson>& all,
                                      const std::filesystem::path& place);

// Fills the misfits of lessons for the case at `place` on these vessels. `before`: the vessels to
// which untied places are tied first; null: untied places count as fitting.
void compare_with(const VesselTree& tree, const std::filesystem::path& place,
                  std::vector<ShelvedLesson>& lessons, const VesselTree* before = nullptr);

}  // namespace hepatica
