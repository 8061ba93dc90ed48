// SPDX-License-Identifier: GPL-3.0-or-later
// After a correction: which lessons for this patient no longer fit his vessels. Looked for beside
// the window, in the folder of his case and in the library's.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "core/patient/patient_case.h"
#include "ui/background_job.h"
#include "ui/shelved_lessons.h"

namespace hepatica {

// UI thread; needs Qt's event loop and nothing else of the toolkit.
class FitKeeper {
  public:
    struct Ways {
        // Those that do not fit; none: all do.
        std::function<void(const std::vector<ShelvedLesson>& unfit)> found;
        std::function<void(const Failure&)> failed;
    };
    explicit FitKeeper(Ways ways) : ways_(std::move(ways)) {}

    // A patient as he is opened. His vessels are what lessons were made on that no editor tied to
    // him. What was looked for is given up.
    void patient_opened(const VesselTree& vessels);
    // Begins; what was looked for before is given up. `place`: the patient's case.
    void look(std::shared_ptr<const PatientCase> patient, const std::filesystem::path& place,
              const std::filesystem::path& library);
    bool working() const { return job_ != nullptr; }

  private:
    Ways ways_;
    std::shared_ptr<const VesselTree> opened_;
    std::unique_ptr<BackgroundJob> job_;
};

}  // namespace hepatica
