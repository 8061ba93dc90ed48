// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the lessons for a patient that no longer fit his vessels after a correction. Searches the
// folder of his case and the library in the background.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "core/patient/patient_case.h"
#include "ui/background_job.h"
#include "ui/shelved_lessons.h"

namespace hepatica {

// UI thread only; needs Qt's event loop and no other part of Qt.
class FitKeeper {
  public:
    struct Ways {
        // The lessons that do not fit; empty if all do.
        std::function<void(const std::vector<ShelvedLesson>& unfit)> found;
        std::function<void(const Failure&)> failed;
    };
    explicit FitKeeper(Ways ways) : ways_(std::move(ways)) {}

    // A patient was opened with these vessels; lessons without ties are compared with them. Cancels
    // a search.
    void patient_opened(const VesselTree& vessels);
    // Starts a search and cancels a former one. `place` is the patient's case.
    void look(std::shared_ptr<const PatientCase> patient, const std::filesystem::path& place,
              const std::filesystem::path& library);
    bool working() const { return job_ != nullptr; }

  private:
    Ways ways_;
    std::shared_ptr<const VesselTree> opened_;
    std::unique_ptr<BackgroundJob> job_;
};

}  // namespace hepatica
