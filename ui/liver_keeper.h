// SPDX-License-Identifier: GPL-3.0-or-later
// The liver's surface around the vessels, computed in the background when it is first wanted.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "core/mesh/tet_mesh.h"
#include "core/patient/patient_case.h"
#include "ui/background_job.h"

namespace hepatica {

// UI thread only; needs Qt's event loop and no other part of Qt.
class LiverKeeper {
  public:
    struct Screen {
        std::function<void(const TriangleMesh&)> show;  // an empty mesh removes the surface
        std::function<void()> none;                     // wanted, but the case has no liver
        std::function<void(const Failure&)> failed;
    };
    explicit LiverKeeper(Screen screen) : screen_(std::move(screen)) {}

    // Sets the patient, null for none. `folder` is his case with the voxels; empty: they are in
    // memory.
    void show_patient(std::shared_ptr<const PatientCase> patient,
                      const std::filesystem::path& folder);
    // Begins to make the surface if that was not tried yet; false makes nothing new.
    void set_wanted(bool wanted);

    bool making() const { return job_ != nullptr; }

  private:
    void make();

    Screen screen_;
    std::shared_ptr<const PatientCase> patient_;
    std::filesystem::path folder_;
    bool wanted_ = false;
    bool made_ = false;  // made or tried for this patient
    std::unique_ptr<BackgroundJob> job_;
};

}  // namespace hepatica
