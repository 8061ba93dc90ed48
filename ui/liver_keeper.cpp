// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/liver_keeper.h"

#include <utility>

#include "core/opening/patient_image.h"
#include "core/patient/liver_segments.h"
#include "render/organ_surface.h"

namespace hepatica {

void LiverKeeper::show_patient(std::shared_ptr<const PatientCase> patient,
                               const std::filesystem::path& folder) {
    job_.reset();
    patient_ = std::move(patient);
    folder_ = folder;
    made_ = false;
    screen_.show({});
    if (wanted_) make();
}

void LiverKeeper::set_wanted(bool wanted) {
    wanted_ = wanted;
    if (wanted_) make();
}

void LiverKeeper::make() {
    if (!patient_ || made_) return;
    made_ = true;
    BackgroundJob::Callbacks callbacks;
    callbacks.failed = screen_.failed;
    callbacks.ended = [this] { job_.reset(); };
    job_ = std::make_unique<BackgroundJob>(
        [this, patient = patient_, folder = folder_](Job& job) -> std::function<void()> {
            const Mask organs = liver_of(organ_voxels(*patient, folder));
            auto liver = std::make_shared<const TriangleMesh>(
                organ_surface(organs, organ_label::liver, job));
            return [this, liver] {
                if (liver->triangles.empty()) return screen_.none();
                screen_.show(*liver);
            };
        },
        std::move(callbacks));
}

}  // namespace hepatica
