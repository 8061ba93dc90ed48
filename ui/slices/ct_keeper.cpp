// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slices/ct_keeper.h"

#include <utility>

#include "core/opening/patient_image.h"
#include "ui/paths.h"

namespace hepatica {

void CtKeeper::show(std::shared_ptr<const PatientCase> patient, const std::filesystem::path& folder,
                    const std::filesystem::path& image) {
    job_.reset();
    tried_ = false;
    patient_ = std::move(patient);
    folder_ = folder;
    if (patient_ && !image.empty())
        settings_.remember_image(patient_->source.image_sha256, to_text(image));
}

std::filesystem::path CtKeeper::known_place() const {
    return to_path(settings_.place_of_image(patient_->source.image_sha256));
}

void CtKeeper::want() {
    if (patient_ && !tried_) read_from(known_place());
}

void CtKeeper::read_from(const std::filesystem::path& place) {
    if (!patient_) return;
    tried_ = true;
    BackgroundJob::Callbacks callbacks;
    callbacks.progress = screen_.progress;
    callbacks.failed = screen_.failed;
    callbacks.cancelled = [] {};
    callbacks.ended = [this] { job_.reset(); };
    job_ = std::make_unique<BackgroundJob>(
        [this, place, patient = patient_, folder = folder_](Job& job) -> std::function<void()> {
            auto ct = std::make_shared<const Volume>(image_of(*patient, place, job));
            auto systems = std::make_shared<Mask>(system_voxels(*patient, folder));
            return [this, place, ct, systems, digest = patient->source.image_sha256] {
                if (!place.empty()) settings_.remember_image(digest, to_text(place));
                screen_.found(ct, std::move(*systems));
            };
        },
        std::move(callbacks));
}

}  // namespace hepatica
