// SPDX-License-Identifier: GPL-3.0-or-later
// Couinaud's segments of the patient who is shown, voxel by voxel: read from his case, or made anew
// where his tree was corrected since, beside the window and when somebody wants to see slices.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <utility>

#include "core/patient/patient_case.h"
#include "ui/background_job.h"

namespace hepatica {

// UI thread; needs Qt's event loop and nothing else of the toolkit.
class SegmentKeeper {
  public:
    struct Screen {
        std::function<void(Mask segments)> found;  // empty: the case knows none
        std::function<void(const Failure&)> failed;
    };
    explicit SegmentKeeper(Screen screen) : screen_(std::move(screen)) {}

    // Of another patient, or of none; `folder` is his case, empty where there is none.
    void show(std::shared_ptr<const PatientCase> patient, const std::filesystem::path& folder);
    // The same patient with another tree than that of his case.
    void show_corrected(std::shared_ptr<const PatientCase> patient);
    // Begins where nothing was found, failed or is being looked for; whether it did.
    bool want();

    bool working() const { return job_ != nullptr; }

  private:
    Screen screen_;
    std::shared_ptr<const PatientCase> patient_;
    std::filesystem::path folder_;
    bool corrected_ = false;
    bool tried_ = false;
    std::unique_ptr<BackgroundJob> job_;
};

}  // namespace hepatica
