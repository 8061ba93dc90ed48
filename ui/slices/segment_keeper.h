// SPDX-License-Identifier: GPL-3.0-or-later
// Couinaud segments of the shown patient as a voxel mask, read from his case in the background when
// slices are wanted, or computed again if his tree was corrected since.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <utility>

#include "core/patient/patient_case.h"
#include "ui/background_job.h"

namespace hepatica {

// UI thread only; needs Qt's event loop and no other part of Qt.
class SegmentKeeper {
  public:
    struct Screen {
        std::function<void(Mask segments)> found;  // empty: the case has no segments
        std::function<void(const Failure&)> failed;
    };
    explicit SegmentKeeper(Screen screen) : screen_(std::move(screen)) {}

    // Sets the patient, null for none; `folder` is his case, may be empty.
    void show(std::shared_ptr<const PatientCase> patient, const std::filesystem::path& folder);
    // The same patient with a tree that differs from that of his case.
    void show_corrected(std::shared_ptr<const PatientCase> patient);
    // Starts reading unless that was already tried; returns whether it started.
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
