// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/corrections_in_words.h"

#include <limits>

#include "core/patient/corrections.h"
#include "core/tree/station.h"
#include "ui/core_words.h"
#include "ui/patient_place.h"
#include "ui/words.h"

namespace hepatica {

bool gives_system(const TreeEdit& edit) {
    return edit.kind == TreeEditKind::reassign_system || edit.kind == TreeEditKind::seed_system;
}

namespace {

// What is offered, or was built by the reconstruction, and this edit decides on; null: nothing.
const Bridge* decided_by(const TreeEdit& edit, const PatientCase& patient) {
    for (const Bridge& bridge : patient.corrections.bridges)
        if (refuses(edit, bridge) || accepts(edit, bridge)) return &bridge;
    return nullptr;
}

QString name_of(const TreeEdit& edit, const PatientCase& patient) {
    switch (edit.kind) {
        case TreeEditKind::cut_link:
            return decided_by(edit, patient) != nullptr ? Words::tr("Gap refused")
                                                        : Words::tr("Vessel cut");
        case TreeEditKind::add_link:
            return edit.path_mm.empty() ? Words::tr("Vessels linked") : Words::tr("Gap bridged");
        case TreeEditKind::delete_branch:
            return Words::tr("Branch deleted");
        case TreeEditKind::delete_tree:
            return Words::tr("Tree deleted");
        case TreeEditKind::set_root:
            return Words::tr("Root set");
        case TreeEditKind::draw_vessel:
            return decided_by(edit, patient) != nullptr ? Words::tr("Branch taken")
                                                        : Words::tr("Vessel drawn");
        case TreeEditKind::seed_system:
            return Words::tr("Whole vessel given to: %1").arg(translated(title_of(edit.system)));
        case TreeEditKind::paint_tumour:
            return Words::tr("Tumour %1 painted").arg(edit.tumour);
        case TreeEditKind::erase_tumour:
            return edit.tumour == 0 ? Words::tr("Tumours erased")
                                    : Words::tr("Tumour %1 erased").arg(edit.tumour);
        case TreeEditKind::refuse_gap:
            if (const Bridge* bridge = decided_by(edit, patient); bridge && bridge->is_branch())
                return Words::tr("Branch refused");
            return Words::tr("Gap refused");
        case TreeEditKind::reassign_system:
            break;
    }
    return Words::tr("Given to: %1").arg(translated(title_of(edit.system)));
}

// The branch in which the place lies, or beside whose wall; null: there is none.
const VesselSegment* branch_there(const Vec3& place_mm, const VesselTree& tree) {
    if (tree.segments.empty()) return nullptr;  // as of a case without corrections
    const TreePoint point = nearest_point(tree, place_mm);
    if (point.segment < 0) return nullptr;
    const VesselSegment& branch = tree.segments[static_cast<std::size_t>(point.segment)];
    const double reach_mm = station_at(branch, point.arclength_mm).radius_mm + beside_wall_mm;
    return point.distance_mm <= reach_mm ? &branch : nullptr;
}

// Coordinates of the place, with the vascular system if a vessel lies there, or lay there before it
// was taken away.
QString there(const Vec3& place_mm, const PatientCase& patient) {
    const VesselSegment* branch = branch_there(place_mm, patient.tree);
    if (branch == nullptr) branch = branch_there(place_mm, patient.corrections.extracted);
    if (branch == nullptr) return patient_place(place_mm);
    return Words::tr("%1 (%2)").arg(patient_place(place_mm), translated(title_of(branch->system)));
}

// The system that a vessel has now says nothing about one that was given: its new system is named.
QString text_of(const TreeEdit& edit, const PatientCase& patient) {
    if (gives_system(edit))
        return Words::tr("%1 at %2").arg(name_of(edit, patient), patient_place(edit.at_mm));
    return Words::tr("%1 at %2").arg(name_of(edit, patient), there(edit.at_mm, patient));
}

QString text_of(const BrushStroke& stroke, const PatientCase& patient) {
    return Words::tr("%1 at %2")
        .arg(stroke.erases ? Words::tr("Vessels erased (waits for Rebuild)")
                           : Words::tr("Vessels painted (waits for Rebuild)"),
             there(stroke.path_mm.front(), patient));
}

QString text_of(const Rebuilding& rebuilding) {
    if (rebuilding.strokes == 0) return Words::tr("Vessels rebuilt");
    return Words::tr("Vessels rebuilt with %n stroke(s)", nullptr,
                     static_cast<int>(rebuilding.strokes));
}

}  // namespace

QString text_of(const Workspace::Step& step, const PatientCase& patient) {
    if (step.stroke) return text_of(*step.stroke, patient);
    if (step.edits.empty()) return Words::tr("Vessels rebuilt");
    if (step.edits.size() == 1) return text_of(step.edits.front(), patient);
    return Words::tr("%n gap(s) and doubtful branch(es) taken", nullptr,
                     static_cast<int>(step.edits.size()));
}

QStringList lines_of_history(const Workspace& workspace) {
    QStringList lines;
    const PatientCase& patient = *workspace.patient();
    const Workspace::Edits& edits = workspace.edits();
    const std::vector<Rebuilding> rebuilt = rebuildings_among(edits, patient.corrections);
    auto rebuilding = rebuilt.begin();
    auto stroke = workspace.strokes().begin();
    const auto add_others = [&](std::size_t edits_before) {
        for (; rebuilding != rebuilt.end() && rebuilding->after_edits <= edits_before; ++rebuilding)
            lines << text_of(*rebuilding);
        for (; stroke != workspace.strokes().end() && stroke->after_edits <= edits_before; ++stroke)
            lines << text_of(stroke->stroke, patient);
    };
    for (auto edit = edits.begin(); edit != edits.end();) {
        add_others(static_cast<std::size_t>(edit - edits.begin()));
        const auto begin = edit++;
        while (edit != edits.end() && of_one_step(*begin, *edit)) ++edit;
        lines << text_of(Workspace::Step{std::nullopt, {begin, edit}}, patient);
    }
    add_others(std::numeric_limits<std::size_t>::max());
    return lines;
}

QString text_of(const Bridge& bridge) {
    const QString text = bridge.is_branch() ? Words::tr("%L1 %, branch of %L2 mm")
                                            : Words::tr("%L1 %, gap of %L2 mm");
    return text.arg(100.0 * bridge.confidence, 0, 'f', 0)
        .arg(bridge.gap_mm, 0, 'f', bridge.is_branch() ? 0 : 1);
}

}  // namespace hepatica
