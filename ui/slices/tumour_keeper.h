// SPDX-License-Identifier: GPL-3.0-or-later
// The tumours of the patient who is shown, as the strokes among his corrections leave them: his
// organs are read beside the window when somebody wants to see slices or he may have tumours, and
// every stroke is shown at once without anything of his vessels being made anew.
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

// UI thread; needs Qt's event loop and nothing else of the toolkit.
class TumourKeeper {
  public:
    struct Screen {
        // The organs as so many strokes have left them on the canvas.
        std::function<void(std::shared_ptr<const Mask> canvas, Mask organs, std::size_t strokes)>
            voxels;
        std::function<void()> none;                        // the patient has no voxels
        std::function<void(const TriangleMesh&)> surface;  // of all tumours; empty: there are none
        std::function<void(const Failure&)> failed;
    };
    explicit TumourKeeper(Screen screen) : screen_(std::move(screen)) {}

    // Of another patient, or of none; `folder` is his case, empty where there is none.
    void show(std::shared_ptr<const PatientCase> patient, const std::filesystem::path& folder);
    // The corrections that are wanted now.
    void follow(const std::vector<TreeEdit>& edits);
    // Begins to read where nothing was read, failed or is being read.
    void want();
    // Once more, where somebody has changed what he was shown.
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
    std::vector<TreeEdit> strokes_, shown_;  // wanted, and those that organs_ has
    std::unique_ptr<BackgroundJob> reading_, drawing_;
};

}  // namespace hepatica
