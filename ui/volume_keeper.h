// SPDX-License-Identifier: GPL-3.0-or-later
// The CT as a volume around the vessels: looked for, read and cut to what is drawn beside the
// window when somebody wants to see it, and not before. Of the CT itself nothing is kept, and
// nothing at all once it is not wanted any more.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "core/patient/patient_case.h"
#include "ui/background_job.h"
#include "ui/slices/ct_keeper.h"

namespace hepatica {

// UI thread; needs Qt's event loop and nothing else of the toolkit. Settings and readings must
// outlive it.
class VolumeKeeper {
  public:
    struct Screen {
        std::function<void(std::shared_ptr<const Volume>)> show;  // null takes it away
        // The CT where slices have read it; null: they have not.
        std::function<std::shared_ptr<const Volume>()> of_slices;
        std::function<void(const JobProgress&)> progress;
        std::function<void(const Failure&)> failed;  // wanted, but not found or not read
    };
    VolumeKeeper(Settings& settings, CtReadings& readings, Screen screen);

    // Another patient, or none: see CtKeeper::show().
    void show_patient(std::shared_ptr<const PatientCase> patient,
                      const std::filesystem::path& folder, const std::filesystem::path& image);
    void set_wanted(bool wanted);
    bool wanted() const { return wanted_; }
    // Reads from there, whatever happened before.
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
