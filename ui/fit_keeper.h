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
    // Those that do not fit; none: all do.
    using Found = std::function<void(const std::vector<ShelvedLesson>& unfit)>;
    explicit FitKeeper(Found found) : found_(std::move(found)) {}

    // Begins; what was looked for before is given up. `place`: the patient's case.
    void look(std::shared_ptr<const PatientCase> patient, const std::filesystem::path& place,
              const std::filesystem::path& library);
    void stop() { job_.reset(); }
    bool working() const { return job_ != nullptr; }

  private:
    Found found_;
    std::unique_ptr<BackgroundJob> job_;
};

}  // namespace hepatica
