// SPDX-License-Identifier: GPL-3.0-or-later
// Provides the CT as a volume around the vessels: reads it and cuts it to the liver's surroundings
// in the background when it is first wanted. Does not keep the whole CT, and nothing once it is no
// longer wanted.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "core/patient/patient_case.h"
#include "ui/background_job.h"
#include "ui/slices/ct_keeper.h"

namespace hepatica {

// UI thread only; needs Qt's event loop and no other part of Qt. Settings and readings must outlive
// it.
class VolumeKeeper {
  public:
    struct Screen {
        std::function<void(std::shared_ptr<const Volume>)> show;  // null removes it
        // The CT that the slices have read; null: none.
        std::function<std::shared_ptr<const Volume>()> of_slices;
        std::function<void(const JobProgress&)> progress;
        std::function<void(const Failure&)> failed;  // wanted, but not found or not readable
    };
    VolumeKeeper(Settings& settings, CtReadings& readings, Screen screen);

    // Sets the patient, null for none: see CtKeeper::show().
    void show_patient(std::shared_ptr<const PatientCase> patient,
                      const std::filesystem::path& folder, const std::filesystem::path& image);
    // Begins to make the volume, or discards it.
    void set_wanted(bool wanted);
    bool wanted() const { return wanted_; }
    // Reads from this place, whatever was tried before. No effect unless wanted.
    void read_from(const std::filesystem::path& place);

    bool making() const { return reader_.reading() || job_ != nullptr; }

  private:
    void make();
    void cut_out(std::shared_ptr<const Volume> ct);
    void forget();

    Screen screen_;
    CtKeeper reader_;
    std::shared_ptr<const PatientCase> patient_;
    std::filesystem::path folder_, image_;
    bool wanted_ = false;
    std::unique_ptr<BackgroundJob> job_;
};

}  // namespace hepatica
