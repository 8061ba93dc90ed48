// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workspace.h"

#include <utility>

namespace hepatica {

void Workspace::open(const OpenedPatient& opened) {
    title_ = opened.title;
    patient_ = opened.patient;
    folder_ = opened.folder;
    image_ = opened.image;
    saved_edits_ = patient_->corrections.edits;
    history_ = {Step{saved_edits_, {}}};
    never_saved_ = opened.worth_saving;
    ++version_;
}

void Workspace::add(const TreeEdit& edit) {
    Step step{edits(), {}};
    step.edits.push_back(edit);
    want(std::move(step));
}

void Workspace::undo() {
    if (!can_undo()) return;
    Step step = history_.back();
    step.undone.push_back(step.edits.back());
    step.edits.pop_back();
    want(std::move(step));
}

void Workspace::redo() {
    if (!can_redo()) return;
    Step step = history_.back();
    step.edits.push_back(step.undone.back());
    step.undone.pop_back();
    want(std::move(step));
}

// Going back to the list before takes the step back: what was undone is not an attempt any more.
void Workspace::want(Step step) {
    ++version_;
    if (awaits_body() && history_[history_.size() - 2].edits == step.edits) {
        history_.pop_back();
        history_.back() = std::move(step);
    } else {
        history_.push_back(std::move(step));
    }
}

std::vector<Workspace::Edits> Workspace::attempts() const {
    std::vector<Edits> lists;
    for (std::size_t i = history_.size(); i-- > 1;) lists.push_back(history_[i].edits);
    return lists;
}

void Workspace::show_body(std::shared_ptr<const PatientCase> patient) {
    patient_ = std::move(patient);
    for (std::size_t i = history_.size(); i-- > 0;) {
        if (history_[i].edits != patient_->corrections.edits) continue;
        if (i + 1 < history_.size()) ++version_;
        history_ = {history_[i]};
        return;
    }
}

void Workspace::give_up_edits() {
    if (!awaits_body()) return;
    history_.resize(1);
    ++version_;
}

bool Workspace::dirty() const {
    return never_saved_ || edits() != saved_edits_;
}

void Workspace::saved(const std::filesystem::path& folder, const Edits& edits) {
    folder_ = folder;
    title_ = folder.filename().string();
    saved_edits_ = edits;
    never_saved_ = false;
}

}  // namespace hepatica
