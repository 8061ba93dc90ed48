// SPDX-License-Identifier: GPL-3.0-or-later
// The CT of the patient who is shown, read beside the window when somebody wants to see it, and not
// before: from where it was opened just now, from where this user's settings know it to lie, or
// from where the person says. The built-in patient's is made anew. What several want at once is
// read once.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "core/patient/patient_case.h"
#include "ui/background_job.h"
#include "ui/settings.h"

namespace hepatica {

class CtKeeper;

// A CT that is being read, and for whom. It ends with the last who waits for it.
struct CtReading {
    std::shared_ptr<const PatientCase> patient;
    std::filesystem::path folder, place;
    std::vector<CtKeeper*> waiting;
    std::unique_ptr<BackgroundJob> job;
};

// The reading that one who comes later can join.
struct CtReadings {
    std::weak_ptr<CtReading> present;
};

// UI thread; needs Qt's event loop and nothing else of the toolkit. Settings and readings must
// outlive it.
class CtKeeper {
  public:
    struct Screen {
        std::function<void(std::shared_ptr<const Volume>, Mask systems)> found;
        std::function<void(const JobProgress&)> progress;
        std::function<void(const Failure&)> failed;
    };
    CtKeeper(Settings& settings, CtReadings& readings, Screen screen)
        : settings_(settings), readings_(readings), screen_(std::move(screen)) {}
    ~CtKeeper() { leave(); }
    CtKeeper(const CtKeeper&) = delete;
    CtKeeper& operator=(const CtKeeper&) = delete;

    // Of another patient, or of none: `folder` is his case and `image` the CT that he was
    // reconstructed from just now, each empty where there is none. Where that CT lies is remembered
    // by its digest, in the settings only.
    void show(std::shared_ptr<const PatientCase> patient, const std::filesystem::path& folder,
              const std::filesystem::path& image);

    // Begins to read where nothing was read, failed or is being read.
    void want();
    // Reads from there, whatever happened before, or waits for another who does; remembered once it
    // has proved to be the one.
    void read_from(const std::filesystem::path& place);

    bool reading() const { return reading_ != nullptr; }

  private:
    std::filesystem::path known_place() const;
    void begin_reading();
    void leave();

    Settings& settings_;
    CtReadings& readings_;
    Screen screen_;
    std::shared_ptr<const PatientCase> patient_;
    std::filesystem::path folder_;
    bool tried_ = false;
    std::shared_ptr<CtReading> reading_;  // that is waited for
};

}  // namespace hepatica
