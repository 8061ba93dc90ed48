// SPDX-License-Identifier: GPL-3.0-or-later
// The CT of the patient who is shown, read beside the window when somebody wants to see it, and not
// before: from where it was opened just now, from where this user's settings know it to lie, or
// from where the person says. The built-in patient's is made anew.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "core/patient/patient_case.h"
#include "ui/background_job.h"
#include "ui/settings.h"

namespace hepatica {

// UI thread; needs Qt's event loop and nothing else of the toolkit. The settings must outlive it.
class CtKeeper {
  public:
    struct Screen {
        std::function<void(std::shared_ptr<const Volume>, Mask systems)> found;
        std::function<void(const JobProgress&)> progress;
        std::function<void(const Failure&)> failed;
    };
    CtKeeper(Settings& settings, Screen screen) : settings_(settings), screen_(std::move(screen)) {}

    // Of another patient, or of none: `folder` is his case and `image` the CT that he was
    // reconstructed from just now, each empty where there is none. Where that CT lies is remembered
    // by its digest, in the settings only.
    void show(std::shared_ptr<const PatientCase> patient, const std::filesystem::path& folder,
              const std::filesystem::path& image);

    // Begins to read where nothing was read, failed or is being read.
    void want();
    // Reads from there, whatever happened before; remembered once it has proved to be the one.
    void read_from(const std::filesystem::path& place);

    bool reading() const { return job_ != nullptr; }

  private:
    std::filesystem::path known_place() const;

    Settings& settings_;
    Screen screen_;
    std::shared_ptr<const PatientCase> patient_;
    std::filesystem::path folder_;
    bool tried_ = false;
    std::unique_ptr<BackgroundJob> job_;
};

}  // namespace hepatica
