// SPDX-License-Identifier: GPL-3.0-or-later
// The lessons that lie in a library's folder, and which of them go with a case: those that name it
// as their patient, and those that go with any patient. No widgets: made on a worker.
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
    QString name;   // of the lesson; where it cannot be read, of the file
    QString about;  // for the trainee, or why it cannot be read
    Patient patient = Patient::any;
    std::filesystem::path of_case;  // whom it names; empty where it goes with any
    // Of one that was laid beside its patient's vessels: its places that are elsewhere now.
    std::vector<std::string> misfits{};
};

// The lessons in the folder itself, by name of file, those that come with the program and go with
// any patient after them. JSON files that are no lessons are passed over; a lesson that is damaged
// says why. Throws Cancelled, and InputError where the folder is there and cannot be read.
std::vector<ShelvedLesson> lessons_in(const std::filesystem::path& folder, Job& job);

// Those that go with the case there: its own first, then those of any patient, then what cannot be
// read.
std::vector<ShelvedLesson> lessons_of(const std::vector<ShelvedLesson>& all,
                                      const std::filesystem::path& place);

// Says of those that name the case there which of their places are elsewhere on these vessels.
// `before`: vessels by which places are judged that no editor has tied; null: those fit.
void compare_with(const VesselTree& tree, const std::filesystem::path& place,
                  std::vector<ShelvedLesson>& lessons, const VesselTree* before = nullptr);

}  // namespace hepatica
