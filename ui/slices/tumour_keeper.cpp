// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slices/tumour_keeper.h"

#include <algorithm>

#include "core/opening/patient_image.h"
#include "render/organ_surface.h"

namespace hepatica {

void TumourKeeper::show(std::shared_ptr<const PatientCase> patient,
                        const std::filesystem::path& folder) {
    reading_.reset();
    drawing_.reset();
    patient_ = std::move(patient);
    folder_ = folder;
    tried_ = false;
    canvas_.reset();
    organs_ = {};
    shown_.clear();
    strokes_.clear();
    screen_.surface({});
    if (!patient_) return;
    strokes_ = tumour_strokes(patient_->corrections.edits);
    if (may_hold_tumours(*patient_)) want();
}

void TumourKeeper::follow(const std::vector<TreeEdit>& edits) {
    if (!patient_) return;
    std::vector<TreeEdit> strokes = tumour_strokes(edits);
    if (strokes == strokes_) return;
    strokes_ = std::move(strokes);
    canvas_ ? renew() : want();
}

void TumourKeeper::want() {
    if (!patient_ || tried_) return;
    tried_ = true;
    BackgroundJob::Callbacks callbacks;
    callbacks.failed = screen_.failed;
    callbacks.ended = [this] { reading_.reset(); };
    reading_ = std::make_unique<BackgroundJob>(
        [this, patient = patient_, folder = folder_](Job&) -> std::function<void()> {
            auto canvas = std::make_shared<Mask>(canvas_voxels(*patient, folder));
            return [this, canvas] { found(std::move(*canvas)); };
        },
        std::move(callbacks));
}

void TumourKeeper::found(Mask canvas) {
    if (canvas.voxels.empty()) return screen_.none();
    canvas_ = std::make_shared<const Mask>(std::move(canvas));
    organs_ = *canvas_;
    renew();
}

// Additional strokes are painted onto the present voxels; after any other change all are painted
// again.
void TumourKeeper::renew() {
    const bool more = shown_.size() <= strokes_.size() &&
                      std::equal(shown_.begin(), shown_.end(), strokes_.begin());
    if (!more) {
        organs_ = *canvas_;
        shown_.clear();
    }
    for (std::size_t i = shown_.size(); i < strokes_.size(); ++i)
        paint_tumour(strokes_[i], *canvas_, organs_);
    shown_ = strokes_;
    show_again();
    draw();
}

void TumourKeeper::show_again() {
    if (canvas_) screen_.voxels(canvas_, organs_, shown_.size());
}

void TumourKeeper::draw() {
    BackgroundJob::Callbacks callbacks;
    callbacks.failed = screen_.failed;
    callbacks.ended = [this] { drawing_.reset(); };
    drawing_ = std::make_unique<BackgroundJob>(
        [this, organs = organs_](Job& job) -> std::function<void()> {
            auto surface =
                std::make_shared<const TriangleMesh>(tumour_surface(tumour_voxels(organs), job));
            return [this, surface] { screen_.surface(*surface); };
        },
        std::move(callbacks));
}

}  // namespace hepatica
