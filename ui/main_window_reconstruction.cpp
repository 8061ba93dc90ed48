// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the window that asks for a reconstruction, and offers again what the shown case was
// made with.
#include "core/opening/built_in_cache.h"
#include "core/reconstruction/reconstruct_parameters.h"
#include "ui/main_window.h"
#include "ui/paths.h"
#include "ui/patient_wizard.h"
#include "ui/settings.h"
#include "ui/slices/view_layout.h"

namespace hepatica {

namespace {

Settings::MaskPlaces places_of_masks(const ReconstructOptions& options) {
    Settings::MaskPlaces places;
    if (options.liver_mask) places.liver = to_text(*options.liver_mask);
    if (options.vessel_mask) places.vessel = to_text(*options.vessel_mask);
    for (const std::filesystem::path& mask : options.tumour_masks) places.tumours << to_text(mask);
    return places;
}

}  // namespace

void MainWindow::ask_for_reconstruction() {
    PatientWizard wizard(settings_.last_folder(), this);
    const SeedMarks& seeds = view_layout_->slices().seeds();
    bool seeds_are_newer = seeds.changed();
    if (!reconstruction_entries_.empty()) {
        wizard.set_entries(reconstruction_entries_);
        seeds_are_newer = seeds.seeds() != seeds_of_entries_;
    } else if (patient_) {
        const CaseSource& source = workspace().patient()->source;
        const bool just_made = !workspace().image().empty();
        const QString ct = just_made ? to_text(workspace().image())
                                     : settings_.place_of_image(source.image_sha256);
        wizard.set_ct(ct, just_made ? workspace().series() : 0);
        seeds_are_newer |= !ct.isEmpty();
        if (patient_->title != built_in_title)
            wizard.set_given(given_parts(source.parameters_json),
                             settings_.places_of_masks(source.image_sha256));
    }
    if (seeds_are_newer) wizard.set_seeds(seeds.seeds());
    if (wizard.exec() != QDialog::Accepted) return;
    reconstruction_entries_ = wizard.entries();
    seeds_of_entries_ = seeds.seeds();
    OpenRequest request = with_absolute_paths({false, wizard.options()});
    reconstruction_ = request.reconstruct;
    open(request);
}

void MainWindow::show_what_it_was_made_with() {
    const CaseSource& source = patient_->patient->source;
    if (!reconstruction_entries_.empty() && patient_->asked_for == reconstruction_.ct)
        settings_.remember_masks(source.image_sha256, places_of_masks(reconstruction_));
    reconstruction_entries_.clear();
    if (patient_->title != built_in_title)
        view_layout_->slices().seeds().show(given_parts(source.parameters_json).seeds);
}

}  // namespace hepatica
