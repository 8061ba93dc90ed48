// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/volume_keeper.h"

#include <utility>

#include "core/opening/ct_around_liver.h"
#include "core/opening/patient_image.h"
#include "ui/words.h"

namespace hepatica {

VolumeKeeper::VolumeKeeper(Settings& settings, CtReadings& readings, Screen screen)
    : screen_(std::move(screen)),
      reader_(settings, readings,
              {[this](std::shared_ptr<const Volume> ct, const Mask& /*systems*/) {
                   cut_out(std::move(ct));
               },
               screen_.progress, screen_.failed}) {}

void VolumeKeeper::show_patient(std::shared_ptr<const PatientCase> patient,
                                const std::filesystem::path& folder,
                                const std::filesystem::path& image) {
    forget();
    patient_ = std::move(patient);
    folder_ = folder;
    image_ = image;
    if (wanted_) make();
}

void VolumeKeeper::set_wanted(bool wanted) {
    if (wanted == wanted_) return;
    wanted_ = wanted;
    wanted_ ? make() : forget();
}

void VolumeKeeper::read_from(const std::filesystem::path& place) {
    if (!patient_ || !wanted_) return;
    reader_.show(patient_, folder_, image_);
    reader_.read_from(place);
}

void VolumeKeeper::make() {
    if (!patient_) return;
    if (auto ct = screen_.of_slices()) return cut_out(std::move(ct));
    reader_.show(patient_, folder_, image_);
    reader_.want();
}

void VolumeKeeper::cut_out(std::shared_ptr<const Volume> ct) {
    BackgroundJob::Callbacks callbacks;
    callbacks.failed = screen_.failed;
    callbacks.ended = [this] { job_.reset(); };
    job_ = std::make_unique<BackgroundJob>(
        [this, ct = std::move(ct), patient = patient_,
         folder = folder_](Job& job) mutable -> std::function<void()> {
            auto around = std::make_shared<const Volume>(
                ct_around_liver(*ct, *patient, organ_voxels(*patient, folder), job));
            ct.reset();  // here, because the job outlives its work for a while
            return [this, around] {
                if (!around->voxels.empty()) return screen_.show(around);
                screen_.failed({Words::id("this CT holds nothing of the patient's liver"), "",
                                Words::id("choose the one that the case was made of")});
            };
        },
        std::move(callbacks));
}

void VolumeKeeper::forget() {
    reader_.show(nullptr, {}, {});
    job_.reset();
    screen_.show(nullptr);
}

}  // namespace hepatica
