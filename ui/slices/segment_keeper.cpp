// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slices/segment_keeper.h"

#include <utility>

#include "core/opening/patient_image.h"

namespace hepatica {

void SegmentKeeper::show(std::shared_ptr<const PatientCase> patient,
                         const std::filesystem::path& folder) {
    job_.reset();
    patient_ = std::move(patient);
    folder_ = folder;
    corrected_ = false;
    tried_ = false;
}

void SegmentKeeper::show_corrected(std::shared_ptr<const PatientCase> patient) {
    job_.reset();
    patient_ = std::move(patient);
    corrected_ = true;
    tried_ = false;
}

bool SegmentKeeper::want() {
    if (!patient_ || tried_) return false;
    tried_ = true;
    BackgroundJob::Callbacks callbacks;
    callbacks.failed = screen_.failed;
    callbacks.ended = [this] { job_.reset(); };
    job_ = std::make_unique<BackgroundJob>(
        [this, patient = patient_, folder = folder_,
         corrected = corrected_](Job& job) -> std::function<void()> {
            auto segments =
                std::make_shared<Mask>(segment_voxels(*patient, folder, corrected, job));
            return [this, segments] { screen_.found(std::move(*segments)); };
        },
        std::move(callbacks));
    return true;
}

}  // namespace hepatica
