// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the CT of the shown patient in the background when it is first wanted: from where it was
// just opened, from the place in the user's settings, or from where the user says. The CT of the
// built-in patient is computed again. Keepers that want the same CT share one reading.
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

// A CT that is being read, and the keepers that wait for it; the last one that leaves ends it.
struct CtReading {
    std::shared_ptr<const PatientCase> patient;
    std::filesystem::path folder, place;
    std::vector<CtKeeper*> waiting;
    std::unique_ptr<BackgroundJob> job;
};

// The reading that later keepers can join.
struct CtReadings {
    std::weak_ptr<CtReading> present;
};

// UI thread only; needs Qt's event loop and no other part of Qt. Settings and readings must outlive
// it.
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

    // Sets the patient, null for none. `folder` is his case and `image` the CT that he was just
    // reconstructed from; each may be empty. The place of that CT is remembered by its digest, in
    // the user's settings only.
    void show(std::shared_ptr<const PatientCase> patient, const std::filesystem::path& folder,
              const std::filesystem::path& image);

    // Starts reading unless that was already tried for this patient.
    void want();
    // Reads from this place, whatever was tried before, or joins a reading of it. The place is
    // remembered once its CT has proved to be the patient's.
    void read_from(const std::filesystem::path& place);

    // Ends the reading; want() begins it again. Another keeper that waits for it still gets it.
    void cancel();
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
    std::shared_ptr<CtReading> reading_;  // the one waited for, else null
};

}  // namespace hepatica
