// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slices/ct_keeper.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/opening/patient_image.h"
#include "ui/paths.h"

namespace hepatica {

void CtKeeper::show(std::shared_ptr<const PatientCase> patient, const std::filesystem::path& folder,
                    const std::filesystem::path& image) {
    leave();
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
    leave();
    reading_ = readings_.present.lock();
    const bool joins = reading_ && reading_->patient == patient_ && reading_->folder == folder_ &&
                       reading_->place == place;
    if (!joins) {
        reading_ = std::make_shared<CtReading>(CtReading{patient_, folder_, place, {}, nullptr});
        readings_.present = reading_;
        begin_reading();
    }
    reading_->waiting.push_back(this);
}

// The job holds the reading weakly, so that it ends with the last keeper that waits for it; it must
// not refer to the keeper that began it.
void CtKeeper::begin_reading() {
    const auto each_waiting = [present = std::weak_ptr(reading_)](const auto& what) {
        const std::shared_ptr<CtReading> reading = present.lock();
        if (!reading) return;
        // A callback may make another keeper leave.
        for (CtKeeper* keeper : std::vector(reading->waiting))
            if (std::ranges::find(reading->waiting, keeper) != reading->waiting.end())
                what(*keeper);
    };
    const auto tell = [each_waiting](const auto& what) {
        each_waiting([&what](const CtKeeper& keeper) { what(keeper.screen_); });
    };
    BackgroundJob::Callbacks callbacks;
    callbacks.progress = [tell](const JobProgress& now) {
        tell([&now](const Screen& screen) { screen.progress(now); });
    };
    callbacks.failed = [tell](const Failure& failure) {
        tell([&failure](const Screen& screen) { screen.failed(failure); });
    };
    callbacks.ended = [each_waiting] { each_waiting([](CtKeeper& keeper) { keeper.leave(); }); };
    reading_->job = std::make_unique<BackgroundJob>(
        [tell, &settings = settings_, place = reading_->place, patient = patient_,
         folder = folder_](Job& job) -> std::function<void()> {
            auto ct = std::make_shared<const Volume>(image_of(*patient, place, job));
            auto systems = std::make_shared<Mask>(system_voxels(*patient, folder));
            return [tell, &settings, place, ct, systems, digest = patient->source.image_sha256] {
                if (!place.empty()) settings.remember_image(digest, to_text(place));
                tell([&](const Screen& screen) { screen.found(ct, *systems); });
            };
        },
        std::move(callbacks));
}

void CtKeeper::cancel() {
    leave();
    tried_ = false;
}

void CtKeeper::leave() {
    if (reading_) std::erase(reading_->waiting, this);
    reading_.reset();
}

}  // namespace hepatica
