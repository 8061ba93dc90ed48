// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of the liver around the vessels, as context: made beside the window when somebody
// wants to see it, and not before.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "core/mesh/tet_mesh.h"
#include "core/patient/patient_case.h"
#include "ui/background_job.h"

namespace hepatica {

// UI thread; needs Qt's event loop and nothing else of the toolkit.
class LiverKeeper {
  public:
    struct Screen {
        std::function<void(const TriangleMesh&)> show;  // an empty one takes it away
        std::function<void()> none;                     // wanted, but the case knows no liver
        std::function<void(const Failure&)> failed;
    };
    explicit LiverKeeper(Screen screen) : screen_(std::move(screen)) {}

    // Another patient, or none. `folder` is his case, which holds the voxels; empty: he has them.
    void show_patient(std::shared_ptr<const PatientCase> patient,
                      const std::filesystem::path& folder);
    void set_wanted(bool wanted);

    bool making() const { return job_ != nullptr; }

  private:
    void make();

    Screen screen_;
    std::shared_ptr<const PatientCase> patient_;
    std::filesystem::path folder_;
    bool wanted_ = false;
    bool made_ = false;  // of this patient, or tried
    std::unique_ptr<BackgroundJob> job_;
};

}  // namespace hepatica
