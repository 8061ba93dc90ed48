// SPDX-License-Identifier: GPL-3.0-or-later
// The tumours of the shown patient with the strokes among his corrections. His organs are read in
// the background when slices are wanted or he may have tumours; a stroke is shown at once and
// leaves the vessels as they are.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "core/mesh/tet_mesh.h"
#include "core/patient/painted_tumours.h"
#include "ui/background_job.h"

namespace hepatica {

// UI thread only; needs Qt's event loop and no other part of Qt.
class TumourKeeper {
  public:
    struct Screen {
        // The organs as `strokes` strokes have left them on the canvas.
        std::function<void(std::shared_ptr<const Mask> canvas, Mask organs, std::size_t strokes)>
            voxels;
        std::function<void()> none;  // the patient has no voxels
        // Of all tumours; empty if there are none.
        std::function<void(const TriangleMesh&)> surface;
        std::function<void(const Failure&)> failed;
    };
    explicit TumourKeeper(Screen screen) : screen_(std::move(screen)) {}

    // Sets the patient, null for none; `folder` is his case, may be empty.
    void show(std::shared_ptr<const PatientCase> patient, const std::filesystem::path& folder);
    // The present list of corrections.
    void follow(const std::vector<TreeEdit>& edits);
    // Starts reading unless that was already tried.
    void want();
    // Sends the voxels again to a receiver that has changed its own.
    void show_again();

    bool working() const { return reading_ || drawing_; }

  private:
    void found(Mask canvas);
    void renew();
    void draw();

    Screen screen_;
    std::shared_ptr<const PatientCase> patient_;
    std::filesystem::path folder_;
    bool tried_ = false;
    std::shared_ptr<const Mask> canvas_;  // null: not known
    Mask organs_;
    std::vector<TreeEdit> strokes_, shown_;  // wanted ones, and those applied to organs_
    std::unique_ptr<BackgroundJob> reading_, drawing_;
};

}  // namespace hepatica
