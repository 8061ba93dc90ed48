// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workspace.h"

#include <utility>

namespace hepatica {

void Workspace::open(const OpenedPatient& opened) {
    title_ = opened.title;
    patient_ = opened.patient;
    folder_ = opened.folder;
    image_ = opened.image;
    kept_copy_ = opened.kept_copy;
    saved_edits_ = patient_->corrections.edits;
    never_saved_ = opened.worth_saving;
    undone_.clear();
    want(saved_edits_);
}

void Workspace::want(Edits edits) {
    edits_ = std::move(edits);
    ++version_;
}

void Workspace::add(const TreeEdit& edit) {
    Edits edits = edits_;
    edits.push_back(edit);
    undone_.clear();
    want(std::move(edits));
}

void Workspace::undo() {
    if (!can_undo()) return;
    Edits edits = edits_;
    undone_.push_back(edits.back());
    edits.pop_back();
    want(std::move(edits));
}

void Workspace::redo() {
    if (!can_redo()) return;
    Edits edits = edits_;
    edits.push_back(undone_.back());
    undone_.pop_back();
    want(std::move(edits));
}

void Workspace::show_body(std::shared_ptr<const PatientCase> patient) {
    patient_ = std::move(patient);
    if (awaits_body()) want(patient_->corrections.edits);
}

void Workspace::give_up_edits() {
    if (!awaits_body()) return;
    undone_.clear();
    want(patient_->corrections.edits);
}

void Workspace::saved(const std::filesystem::path& folder, const Edits& edits) {
    folder_ = folder;
    title_ = folder.filename().string();
    saved_edits_ = edits;
    never_saved_ = false;
}

}  // namespace hepatica
