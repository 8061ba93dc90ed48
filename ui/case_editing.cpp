// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/case_editing.h"

#include <algorithm>
#include <utility>

namespace hepatica {
namespace {

Vec3 position_of(const VesselTree& tree, const TreePoint& point) {
    const VesselSegment& segment = tree.segments[static_cast<std::size_t>(point.segment)];
    double along = point.arclength_mm;
    for (std::size_t i = 1; i < segment.points_mm.size(); ++i) {
        const Vec3 step = segment.points_mm[i] - segment.points_mm[i - 1];
        if (along <= step.norm()) return segment.points_mm[i - 1] + along / step.norm() * step;
        along -= step.norm();
    }
    return segment.points_mm.back();
}

QString text_of(const TreeEdit& edit) {
    switch (edit.kind) {
        case TreeEditKind::cut_link:
            return "Vessel cut";
        case TreeEditKind::add_link:
            return edit.path_mm.empty() ? "Vessels linked" : "Gap bridged";
        case TreeEditKind::delete_branch:
            return "Branch deleted";
        case TreeEditKind::set_root:
            return "Root set";
        case TreeEditKind::reassign_system:
            break;
    }
    return QString("Given to system %1").arg(edit.system);
}

QString text_of(const Bridge& bridge) {
    return QString("%1 %, gap of %2 mm")
        .arg(100.0 * bridge.confidence, 0, 'f', 0)
        .arg(bridge.gap_mm, 0, 'f', 1);
}

}  // namespace

CaseEditing::CaseEditing(EditPanel& panel, Callbacks callbacks)
    : panel_(panel), callbacks_(std::move(callbacks)) {
    panel_.set_callbacks({[this](int bridge) { choose_bridge(bridge); },
                          [this](int bridge) { accept(bridge); }, [this] { undo(); },
                          [this] { redo(); }, [this] { link_from_mm_.reset(); }});
}

void CaseEditing::show(std::shared_ptr<const PatientCase> patient, bool rebuilt) {
    patient_ = std::move(patient);
    wanted_ = patient_->corrections.edits;
    if (!rebuilt) undone_.clear();
    link_from_mm_.reset();
    bridges_ = open_bridges(*patient_);
    callbacks_.show_bridges(views_of(bridges_));
    update_panel();
}

void CaseEditing::job_ended() {
    if (!patient_ || wanted_ == patient_->corrections.edits) return;
    wanted_ = patient_->corrections.edits;
    undone_.clear();
    update_panel();
}

void CaseEditing::update_panel() {
    QStringList bridges, edits;
    for (const Bridge& bridge : bridges_) bridges << text_of(bridge);
    for (const TreeEdit& edit : wanted_) edits << text_of(edit);
    panel_.show_bridges(bridges);
    panel_.show_edits(edits, !wanted_.empty(), !undone_.empty());
    QStringList state;
    if (wanted_ != patient_->corrections.edits)
        state << "The body of the corrected tree is being made; the view shows the one before.";
    const auto built = std::ranges::count(patient_->corrections.bridges, true, &Bridge::built);
    if (built > 0)
        state << QString("%1 gaps were bridged by the reconstruction, %2 mm in all.")
                     .arg(built)
                     .arg(bridged_length_mm(patient_->tree), 0, 'f', 1);
    panel_.show_state(state.join("\n"));
}

void CaseEditing::choose_bridge(int bridge) {
    std::vector<BridgeView> views = views_of(bridges_);
    if (bridge >= 0 && bridge < static_cast<int>(views.size()))
        views[static_cast<std::size_t>(bridge)].chosen = true;
    callbacks_.show_bridges(std::move(views));
}

void CaseEditing::want(std::vector<TreeEdit> edits) {
    wanted_ = std::move(edits);
    update_panel();
    callbacks_.rebuild(wanted_);
}

void CaseEditing::add(const TreeEdit& edit) {
    undone_.clear();
    std::vector<TreeEdit> edits = wanted_;
    edits.push_back(edit);
    want(std::move(edits));
}

void CaseEditing::click(const TreePoint& point) {
    if (!patient_ || point.segment < 0) return;
    TreeEdit edit;
    edit.kind = panel_.tool();
    edit.at_mm = position_of(patient_->tree, point);
    edit.system = edit.kind == TreeEditKind::reassign_system ? panel_.system() : 0;
    if (edit.kind == TreeEditKind::add_link) {
        if (!link_from_mm_) {
            link_from_mm_ = edit.at_mm;
            return callbacks_.say("Now click the vessel that it shall be linked with");
        }
        edit.to_mm = std::exchange(edit.at_mm, *link_from_mm_);
        link_from_mm_.reset();
    }
    add(edit);
}

void CaseEditing::accept(int bridge) {
    if (bridge < 0 || bridge >= static_cast<int>(bridges_.size())) return;
    add(acceptance_of(bridges_[static_cast<std::size_t>(bridge)]));
}

void CaseEditing::undo() {
    if (wanted_.empty()) return;
    std::vector<TreeEdit> edits = wanted_;
    undone_.push_back(edits.back());
    edits.pop_back();
    want(std::move(edits));
}

void CaseEditing::redo() {
    if (undone_.empty()) return;
    std::vector<TreeEdit> edits = wanted_;
    edits.push_back(undone_.back());
    undone_.pop_back();
    want(std::move(edits));
}

}  // namespace hepatica
