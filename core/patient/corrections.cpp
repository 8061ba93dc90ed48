// SPDX-License-Identifier: GPL-3.0-or-later
// Applies edits to the extracted tree, and derives the states of offered bridges.
#include "core/patient/corrections.h"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/json_number.h"
#include "core/base/patient_space.h"
#include "core/mesh/manifold_attempts.h"
#include "core/mesh/surface.h"
#include "core/mesh/tetrahedralize.h"
#include "core/patient/branch_offers.h"
#include "core/patient/case_header.h"
#include "core/patient/liver_segments.h"
#include "core/patient/painted_tumours.h"
#include "core/tree/editing/doubtful_link.h"

namespace hepatica {

namespace {

// The root segment of the tree that each segment belongs to.
std::vector<int> root_of_segments(const VesselTree& tree) {
    std::vector<int> root(tree.segments.size());
    for (std::size_t i = 0; i < root.size(); ++i)
        root[i] = tree.segments[i].parent < 0 ? static_cast<int>(i) : root[tree.segments[i].parent];
    return root;
}

// Whether the vessels nearest to these places are of one tree. The tree must have segments.
bool hang_together(const VesselTree& tree, const Vec3& first_mm, const Vec3& second_mm) {
    const std::vector<int> root = root_of_segments(tree);
    return root[nearest_point(tree, first_mm).segment] ==
           root[nearest_point(tree, second_mm).segment];
}

bool fits(const VesselTree& tree, const Bridge& bridge) {
    if (tree.segments.empty()) return false;
    if (bridge.is_branch()) return leads_out_of(tree, bridge);
    return !hang_together(tree, bridge.path_mm.front(), bridge.path_mm.back());
}

// Whether this link, made on the tree `before`, still joins what it joined. A vessel that was
// deleted since is farther from the link's end than it was.
bool still_joins(const TreeEdit& link, const VesselTree& before, const VesselTree& now) {
    constexpr double moved_mm = 1.0;  // by the cut of another link, or the gap of a cut
    if (now.segments.empty()) return false;
    const auto is_there = [&](const Vec3& end_mm) {
        return nearest_point(now, end_mm).distance_mm <=
               nearest_point(before, end_mm).distance_mm + moved_mm;
    };
    return is_there(link.at_mm) && is_there(link.to_mm) &&
           hang_together(now, link.at_mm, link.to_mm);
}

VesselTree edited_by_all(VesselTree tree, const std::vector<TreeEdit>& edits) {
    for (std::size_t i = 0; i < edits.size(); ++i) {
        try {
            tree = edited(tree, edits[i]);
        } catch (const InputError& error) {
            throw InputError(error.problem(),
                             "edit " + std::to_string(i + 1) + " at " + error.place(),
                             error.remedy());
        }
    }
    if (tree.segments.empty())
        throw InputError("the edits leave nothing of the tree", "the last edit",
                         "Take it back, or delete a smaller branch");
    return tree;
}

// Replaces `value` where the case has a parameter of the mesh with this name.
void take_mesh_parameter(const nlohmann::json& mesh, const char* name, double& value) {
    if (!mesh.contains(name)) return;
    if (!mesh[name].is_number())
        refuse_case(case_file::header, std::string("its parameter mesh.") + name + " is " +
                                           mesh[name].dump() + ", not a number");
    value = mesh[name].get<double>();
}

void take_mesh_parameter(const nlohmann::json& mesh, const char* name, int& value) {
    if (!mesh.contains(name)) return;
    try {
        value = whole_number<int>(mesh[name]);
    } catch (const nlohmann::json::exception&) {
        refuse_case(case_file::header, std::string("its parameter mesh.") + name + " is " +
                                           mesh[name].dump() + ", not a whole number in range");
    }
}

}  // namespace

MeshOptions mesh_options_of(const PatientCase& patient) {
    MeshOptions options;
    const auto parameters = nlohmann::json::parse(patient.source.parameters_json, nullptr, false);
    if (!parameters.is_object() || !parameters.contains("mesh")) return options;
    const auto& mesh = parameters["mesh"];
    if (!mesh.is_object())
        refuse_case(case_file::header, "its parameter mesh is " + mesh.dump() + ", not an object");
    take_mesh_parameter(mesh, "facet_size_in_radii", options.facet_size_in_radii);
    take_mesh_parameter(mesh, "cell_size_in_radii", options.cell_size_in_radii);
    take_mesh_parameter(mesh, "target_tetrahedra", options.target_tetrahedra);
    take_mesh_parameter(mesh, "minimum_radius_mm", options.minimum_radius_mm);
    return options;
}

std::string name_of(BridgeState state) {
    switch (state) {
        case BridgeState::open:
            return "open";
        case BridgeState::built:
            return "built";
        case BridgeState::accepted:
            return "accepted";
        case BridgeState::refused:
            return "refused";
        case BridgeState::needless:
            break;
    }
    return "needless";
}

BridgeState state_of_bridge(const PatientCase& patient, std::size_t index) {
    const Bridge& bridge = patient.corrections.bridges[index];
    const std::vector<TreeEdit>& edits = patient.corrections.edits;
    const auto accepts_it = [&](const TreeEdit& edit) { return accepts(edit, bridge); };
    if (std::ranges::any_of(edits, accepts_it)) return BridgeState::accepted;
    const auto refuses_it = [&](const TreeEdit& edit) { return refuses(edit, bridge); };
    if (std::ranges::any_of(edits, refuses_it)) return BridgeState::refused;
    if (bridge.built) return BridgeState::built;
    return fits(patient.tree, bridge) ? BridgeState::open : BridgeState::needless;
}

std::vector<Bridge> open_bridges(const PatientCase& patient) {
    std::vector<Bridge> open;
    for (std::size_t i = 0; i < patient.corrections.bridges.size(); ++i)
        if (state_of_bridge(patient, i) == BridgeState::open)
            open.push_back(patient.corrections.bridges[i]);
    std::ranges::stable_sort(open, std::ranges::greater{}, &Bridge::confidence);
    return open;
}

std::vector<Bridge> open_gaps(const PatientCase& patient) {
    std::vector<Bridge> gaps = open_bridges(patient);
    std::erase_if(gaps, [](const Bridge& bridge) { return bridge.is_branch(); });
    return gaps;
}

TreeEdit acceptance_of(const Bridge& bridge) {
    if (bridge.is_branch()) return drawing_of({bridge.path_mm, bridge.radii_mm});
    TreeEdit link;
    link.kind = TreeEditKind::add_link;
    link.at_mm = bridge.path_mm.front();
    link.to_mm = bridge.path_mm.back();
    link.path_mm = bridge.path_mm;
    return link;
}

bool accepts(const TreeEdit& edit, const Bridge& bridge) {
    return (edit.kind == TreeEditKind::add_link || edit.kind == TreeEditKind::draw_vessel) &&
           edit.path_mm == bridge.path_mm;
}

TreeEdit refusal_of(const Bridge& bridge) {
    TreeEdit refusal;
    if (bridge.built) {
        refusal.kind = TreeEditKind::cut_link;
        refusal.at_mm = bridge.path_mm[bridge.path_mm.size() / 2];
    } else {
        refusal.kind = TreeEditKind::refuse_gap;
        refusal.at_mm = bridge.path_mm.front();
        refusal.to_mm = bridge.path_mm.back();
    }
    return refusal;
}

bool refuses(const TreeEdit& edit, const Bridge& bridge) {
    if (bridge.built) return edit == refusal_of(bridge);
    if (edit.kind != TreeEditKind::refuse_gap) return false;
    constexpr double reach_mm = 3.0;
    const auto goes = [&](const Vec3& from, const Vec3& to) {
        return (edit.at_mm - from).norm() <= reach_mm && (edit.to_mm - to).norm() <= reach_mm;
    };
    const Vec3 &from = bridge.path_mm.front(), &to = bridge.path_mm.back();
    return goes(from, to) || goes(to, from);
}

namespace {

// Those of this confidence that are open, and branches that hang on no vessel now but may hang on
// one that is taken; the surest first.
std::vector<Bridge> acceptable(const PatientCase& patient, double confidence, Job& job) {
    std::vector<Bridge> found;
    const std::vector<Bridge>& bridges = patient.corrections.bridges;
    for (std::size_t i = 0; i < bridges.size(); ++i) {
        job.advance(static_cast<double>(i) / static_cast<double>(bridges.size()));
        if (bridges[i].confidence < confidence) continue;
        const BridgeState state = state_of_bridge(patient, i);
        const bool may_fit = state == BridgeState::needless && bridges[i].is_branch();
        if (state == BridgeState::open || may_fit) found.push_back(bridges[i]);
    }
    std::ranges::stable_sort(found, std::ranges::greater{}, &Bridge::confidence);
    return found;
}

}  // namespace

std::vector<TreeEdit> acceptances(const PatientCase& patient, double confidence, Job& job) {
    std::vector<Bridge> waiting =
        in_part(job, 0.0, 0.1, [&] { return acceptable(patient, confidence, job); });
    const JobPart rest(job, 0.1, 1.0);
    const auto all = static_cast<double>(waiting.size());
    std::vector<TreeEdit> accepted;
    VesselTree tree = patient.tree;
    const auto take = [&](const Bridge& bridge) {
        if (!fits(tree, bridge)) return false;
        try {
            tree = edited(tree, acceptance_of(bridge));
            accepted.push_back(acceptance_of(bridge));
        } catch (const InputError&) {
            // It would join two systems, for example: by itself it says why.
        }
        return true;
    };
    for (bool more = true; more;) {
        std::vector<Bridge> left;
        double looked_at = all - static_cast<double>(waiting.size());
        for (const Bridge& bridge : waiting) {
            job.advance(looked_at++ / all);
            if (!take(bridge)) left.push_back(bridge);
        }
        more = left.size() < waiting.size();
        waiting = std::move(left);
    }
    return accepted;
}

std::vector<std::string> doubts_of_links(const PatientCase& patient) {
    const std::vector<TreeEdit>& edits = patient.corrections.edits;
    std::vector<std::string> doubts;
    VesselTree tree = patient.corrections.extracted;
    auto made = edits.begin();  // in `tree`
    try {
        for (auto link = made; link != edits.end(); ++link) {
            if (link->kind != TreeEditKind::add_link) continue;
            for (; made != link; ++made) tree = edited(tree, *made);
            if (!still_joins(*link, tree, patient.tree)) continue;
            for (std::string& doubt : doubts_of_link(tree, *link))
                if (std::ranges::find(doubts, doubt) == doubts.end())
                    doubts.push_back(std::move(doubt));
        }
    } catch (const InputError&) {
        // Of an edit that another program made, and that this one cannot: doubts before it count.
    }
    return doubts;
}

PatientCase with_edited_tree(const PatientCase& patient, const std::vector<TreeEdit>& edits) {
    PatientCase result = patient;
    Corrections& corrections = result.corrections;
    if (corrections.edits.empty()) corrections.extracted = result.tree;
    result.tree = edited_by_all(corrections.extracted, edits);
    corrections.rebuilt = rebuildings_among(edits, corrections);
    corrections.edits = edits;
    if (edits.empty()) corrections.extracted = {};
    return result;
}

std::vector<TreeEdit> acceptances_after(const PatientCase& patient,
                                        const std::vector<TreeEdit>& edits, double confidence,
                                        Job& job) {
    PatientCase wanted;  // without its voxels and its body, which count for nothing
    wanted.tree = patient.tree;
    wanted.corrections = patient.corrections;
    return acceptances(with_edited_tree(wanted, edits), confidence, job);
}

namespace {

// Applies the edits, tumour strokes included, without a new mesh.
PatientCase edited_without_body(const PatientCase& patient, const std::vector<TreeEdit>& edits) {
    PatientCase result = with_edited_tree(patient, edits);
    if (tumour_strokes(edits) == tumour_strokes(patient.corrections.edits)) return result;
    if (const auto idle = paint_tumours(result, edits))
        throw InputError(
            edits[*idle].kind == TreeEditKind::erase_tumour
                ? "there is no such tumour to be erased"
                : "there is nothing that could become tumour",
            "edit " + std::to_string(*idle + 1) + " at " + place_text(edits[*idle].at_mm),
            "Lead the brush elsewhere, or take the edit out");
    return result;
}

}  // namespace

PatientCase with_edits(const PatientCase& patient, const std::vector<TreeEdit>& edits, Job& job) {
    job.begin_stage("Editing the tree");
    const bool same = edits == patient.corrections.edits;
    PatientCase result = same ? patient : edited_without_body(patient, edits);
    job.begin_stage("Meshing the vessels");
    if (same) return result;
    if (tree_edits(edits) != tree_edits(patient.corrections.edits)) {
        std::vector<std::string> of_mesh;
        result.mesh = tetrahedralize(result.tree, mesh_options_of(patient), job, &of_mesh);
        replace_warnings_of_mesh(of_mesh, result);
        result.surface = surface_of(result.mesh).mesh;
    }
    label_segments(result, job);
    return result;
}

void replace_warnings_of_mesh(const std::vector<std::string>& of_mesh, PatientCase& patient) {
    std::erase_if(patient.warnings,
                  [](const std::string& warning) { return is_of_unclosed(warning); });
    patient.warnings.insert(patient.warnings.end(), of_mesh.begin(), of_mesh.end());
}

namespace {

std::vector<Rebuilding> after_at_most(std::size_t edits, std::vector<Rebuilding> rebuilt) {
    for (Rebuilding& one : rebuilt) one.after_edits = std::min(one.after_edits, edits);
    return rebuilt;
}

}  // namespace

std::vector<Rebuilding> rebuildings_among(const std::vector<TreeEdit>& edits,
                                          const Corrections& corrections) {
    const std::vector<TreeEdit>& before = corrections.edits;
    const auto changed =
        std::mismatch(edits.begin(), edits.end(), before.begin(), before.end()).first;
    if (changed == edits.end()) return corrections.rebuilt;  // as long as no other body is made
    return after_at_most(static_cast<std::size_t>(changed - edits.begin()), corrections.rebuilt);
}

void note_rebuilding(const PatientCase& before, std::size_t strokes, PatientCase& after) {
    const std::size_t edits = after.corrections.edits.size();
    after.corrections.rebuilt = after_at_most(edits, before.corrections.rebuilt);
    after.corrections.rebuilt.push_back({edits, strokes});
}

}  // namespace hepatica
