// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/case_editing.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>
#include <utility>

#include "core/base/error.h"
#include "core/tree/editing/doubtful_link.h"
#include "core/tree/editing/edit_reach.h"
#include "core/tree/editing/given_already.h"
#include "core/tree/editing/vessel_tracing.h"
#include "core/tree/station.h"
#include "ui/core_words.h"
#include "ui/corrections_in_words.h"
#include "ui/words.h"

namespace hepatica {
namespace {

int root_of(int segment, const VesselTree& tree) {
    int parent = segment;
    while (parent >= 0) {
        segment = parent;
        parent = tree.segments[static_cast<std::size_t>(segment)].parent;
    }
    return segment;
}

// The root of the vessel of this system there, within an edit's reach; -1: there is none.
int root_there(const Vec3& place_mm, VascularSystem system, const VesselTree& tree) {
    const TreePoint at = nearest_point(tree, place_mm);
    if (at.segment < 0 || at.distance_mm > edit_reach_mm) return -1;
    const bool is_of_system = tree.segments[static_cast<std::size_t>(at.segment)].system == system;
    return is_of_system ? root_of(at.segment, tree) : -1;
}

// Whether the vessel that lies there is of this system. Nearer than its wall: another one beside it
// says nothing.
bool lies_in_system(const Vec3& place_mm, VascularSystem system, const VesselTree& tree) {
    const TreePoint at = nearest_point(tree, place_mm);
    if (at.segment < 0) return false;
    const VesselSegment& segment = tree.segments[static_cast<std::size_t>(at.segment)];
    return segment.system == system &&
           at.distance_mm <= station_at(segment, at.arclength_mm).radius_mm;
}

// Whether this edit made a new tree of its system, in which nothing was of it before: neither one
// that a later edit gave away again, nor one that another edit cut off.
bool made_a_tree(const TreeEdit& edit, const VesselTree& before, const VesselTree& tree) {
    const int own = root_there(edit.at_mm, edit.system, tree);
    if (own < 0) return false;
    for (int s = 0; s < std::ssize(tree.segments); ++s) {
        if (root_of(s, tree) != own) continue;
        const VesselSegment& segment = tree.segments[static_cast<std::size_t>(s)];
        const Vec3 middle_mm = station_at(segment, 0.5 * length_mm(segment)).position_mm;
        if (lies_in_system(middle_mm, edit.system, before)) return false;
    }
    return true;
}

// A place in each other tree of the system to which this edit gave a vessel. In the middle of its
// first segment, because the begin may lie where vessels of other systems meet, too.
std::vector<Vec3> other_trees(const TreeEdit& edit, const VesselTree& tree) {
    const int own = root_there(edit.at_mm, edit.system, tree);
    std::vector<Vec3> others;
    for (const int root : roots(tree)) {
        const VesselSegment& segment = tree.segments[static_cast<std::size_t>(root)];
        if (root != own && segment.system == edit.system)
            others.push_back(station_at(segment, 0.5 * length_mm(segment)).position_mm);
    }
    return others;
}

}  // namespace

// Whether it still is a tree of its own, beside others of its system.
bool CaseEditing::is_apart(const GivenApart& given, const VesselTree& tree) {
    const int own = root_there(given.at_mm, given.system, tree);
    bool has_others = false;
    for (const Vec3& other : given.others_mm) {
        const int root = root_there(other, given.system, tree);
        if (root >= 0 && root == own) return false;
        has_others |= root >= 0;
    }
    return own >= 0 && has_others;
}

CaseEditing::CaseEditing(EditPanel& panel, const Workspace& workspace, Callbacks callbacks)
    : panel_(panel), workspace_(workspace), callbacks_(std::move(callbacks)) {
    panel_.set_callbacks(
        {[this](int /*row*/) { draw_bridges(); }, [this](int row) { accept(row); },
         [this](int row) { refuse(row); }, [this] { callbacks_.accept_all(least_confidence_); },
         [this](double confidence) {
             least_confidence_ = confidence;
             if (workspace_.has_patient()) show_bridges();
         },
         callbacks_.undo, callbacks_.redo, [this] { begin_link({}); }, [this] { click_chosen(); }});
}

void CaseEditing::show_body() {
    link_from_mm_.reset();
    warn_of_new_doubts();
    show_bridges();
    update_panel();
}

// Doubts about an uncorrected tree are shown when it is opened. Fewer loops are no new doubt.
void CaseEditing::warn_of_new_doubts() {
    const VesselTree& tree = workspace_.patient()->tree;
    std::vector<std::string> now = doubts_of_links(*workspace_.patient());
    std::ranges::copy(sentences(std::nullopt, tree), std::back_inserter(now));
    std::vector<std::string> before = std::exchange(doubts_, std::move(now));
    std::ranges::move(std::exchange(told_of_link_, {}), std::back_inserter(before));
    const int loops_before = std::exchange(loops_, doubts_of(tree).loops);
    QStringList fresh = given_apart();
    if (workspace_.patient()->corrections.edits.empty()) return;
    for (const std::string& doubt : doubts_) {
        const bool of_loops = &doubt == &doubts_.back() && loops_ > 0;
        const bool is_new =
            of_loops ? loops_ > loops_before : std::ranges::find(before, doubt) == before.end();
        if (is_new) fresh << translated(doubt);
    }
    if (!fresh.isEmpty()) callbacks_.warn(fresh.join("\n"));
}

QStringList CaseEditing::given_apart() {
    const VesselTree& tree = workspace_.patient()->tree;
    const std::vector<TreeEdit>& edits = workspace_.patient()->corrections.edits;
    const auto before = std::exchange(shown_, workspace_.patient());
    if (std::exchange(opening_, workspace_.opening()) != workspace_.opening()) apart_.clear();
    for (GivenApart& given : apart_) given.still = is_apart(given, tree);
    QStringList list;
    // After undoing, or with other vessels, there is nothing to compare with.
    const bool same_vessels = std::exchange(origin_, workspace_.origin()) == workspace_.origin();
    if (!same_vessels || !before) return list;
    const std::vector<TreeEdit>& old = before->corrections.edits;
    if (edits.size() < old.size() || !std::equal(old.begin(), old.end(), edits.begin()))
        return list;
    for (std::size_t i = old.size(); i < edits.size(); ++i) {
        const VascularSystem system = edits[i].system;
        if (!gives_system(edits[i]) || system == VascularSystem::unknown) continue;
        std::vector<Vec3> others_mm = other_trees(edits[i], tree);
        if (others_mm.empty() || !made_a_tree(edits[i], before->tree, tree)) continue;
        const QString doubt =
            Words::tr(
                "The vessel given to the system \"%1\" touches no other vessel of it and is "
                "a tree of its own: neither blood nor a drug comes to it from the others. If "
                "it belongs to one of them, choose Link two vessels and click both.")
                .arg(translated(title_of(system)));
        if (!list.contains(doubt)) list << doubt;
        std::erase_if(apart_, [&](const GivenApart& given) {
            return given.doubt == doubt && given.at_mm == edits[i].at_mm;
        });
        apart_.push_back({doubt, system, edits[i].at_mm, std::move(others_mm), true});
    }
    return list;
}

bool CaseEditing::stands(const QString& doubt) const {
    return std::ranges::any_of(
               apart_,
               [&](const GivenApart& given) { return given.still && given.doubt == doubt; }) ||
           std::ranges::any_of(doubts_,
                               [&](const std::string& one) { return translated(one) == doubt; });
}

// Also by corrections whose body is still being made, or that need none.
CaseEditing::Bridges CaseEditing::bridges_now() const {
    PatientCase now;
    now.tree = workspace_.patient()->tree;
    now.corrections.bridges = workspace_.patient()->corrections.bridges;
    now.corrections.edits = workspace_.edits();
    Bridges bridges;
    for (std::size_t i = 0; i < now.corrections.bridges.size(); ++i) {
        const BridgeState state = state_of_bridge(now, i);
        if (state == BridgeState::open) bridges.open.push_back(now.corrections.bridges[i]);
        if (state == BridgeState::built) bridges.built.push_back(now.corrections.bridges[i]);
    }
    std::ranges::stable_sort(bridges.open, std::ranges::greater{}, &Bridge::confidence);
    return bridges;
}

void CaseEditing::show_bridges() {
    list_bridges(bridges_now());
}

void CaseEditing::list_bridges(Bridges now) {
    bridges_ = std::move(now.open);
    built_ = std::move(now.built);
    std::ranges::reverse(built_);
    bridges_listed_ = bridges_.size();
    const std::size_t hidden = std::erase_if(
        bridges_, [this](const Bridge& bridge) { return bridge.confidence < least_confidence_; });
    QStringList offered, built;
    for (const Bridge& bridge : bridges_) offered << text_of(bridge);
    for (const Bridge& bridge : built_) built << Words::tr("bridged: %1").arg(text_of(bridge));
    panel_.show_bridges(offered, built, hidden);
    draw_bridges();
}

PatientCase CaseEditing::wanted() const {
    PatientCase wanted;
    wanted.tree = workspace_.patient()->tree;
    wanted.corrections = workspace_.patient()->corrections;
    if (!workspace_.awaits_body()) return wanted;
    return with_edited_tree(wanted, workspace_.edits());
}

void CaseEditing::add(const TreeEdit& edit) {
    bool is_given = false, settles = false;
    std::vector<std::string> link_doubts;
    if (gives_system(edit) || edit.kind == TreeEditKind::add_link) try {
            const VesselTree tree = wanted().tree;
            is_given = is_given_already(tree, edit);
            settles = settles_a_doubt(tree, edit);
            link_doubts = doubts_of_link(tree, edit);
        } catch (const InputError&) {
            // A correction before it is impossible, of which the worker tells.
        }
    if (!is_given || settles) callbacks_.add(edit);
    if (!link_doubts.empty()) warn_of_link(edit, link_doubts);
    if (!is_given) return;
    const QString words = settles
                              ? Words::tr("Confirmed: its system counts as sure from now on (%1)")
                              : Words::tr("Nothing to do: it is of this system already (%1)");
    callbacks_.say(words.arg(translated(title_of(edit.system))));
}

void CaseEditing::warn_of_link(const TreeEdit& link, const std::vector<std::string>& doubts) {
    if (workspace_.edits().empty() || workspace_.edits().back() != link) return;  // it was refused
    QStringList lines;
    for (const std::string& doubt : doubts) lines << translated(doubt);
    callbacks_.warn_of_link(lines.join("\n"), link);
    std::ranges::copy(doubts, std::back_inserter(told_of_link_));
}

void CaseEditing::update_panel() {
    if (!workspace_.has_patient()) return;
    // Only where another is offered: the list forgets which row is chosen if its words change.
    Bridges now = bridges_now();
    if (now.open.size() != bridges_listed_ || now.built.size() != built_.size())
        list_bridges(std::move(now));
    panel_.show_edits(lines_of_history(workspace_));
    show_history();
    QStringList state;
    if (workspace_.awaits_body())
        state << Words::tr(
            "The body of the corrected tree is being made; the view shows the one before.");
    double bridged_mm = 0.0;
    for (const Bridge& bridge : built_) bridged_mm += bridge.gap_mm;
    if (!built_.empty())
        state << Words::tr("%n gap(s) were bridged by the reconstruction, %L1 mm in all.", nullptr,
                           static_cast<int>(built_.size()))
                     .arg(bridged_mm, 0, 'f', 1);
    for (const std::string& doubt : doubts_) state << "⚠ " + translated(doubt);
    panel_.show_state(state.join("\n"));
}

void CaseEditing::show_history() {
    if (!workspace_.has_patient()) return;
    const PatientCase& patient = *workspace_.patient();
    QString undo = Words::tr("Last point"), redo;
    if (!callbacks_.points_wait()) {
        const auto last = workspace_.next_undo(), next = workspace_.next_redo();
        undo = last ? text_of(*last, patient) : QString();
        redo = next ? text_of(*next, patient) : QString();
    }
    panel_.show_history(!undo.isEmpty(), !redo.isEmpty());
    callbacks_.show_history(undo, redo);
}

const Bridge* CaseEditing::bridge_of(int row) const {
    if (row < 0) return nullptr;
    auto index = static_cast<std::size_t>(row);
    if (index < built_.size()) return &built_[index];
    index -= built_.size();
    return index < bridges_.size() ? &bridges_[index] : nullptr;
}

// Of the built ones, which the view shows as vessels, only the chosen one is drawn.
void CaseEditing::draw_bridges() {
    const int chosen_row = panel_.chosen_bridge();
    std::vector<BridgeView> views;
    drawn_.clear();
    for (int row = 0; const Bridge* bridge = bridge_of(row); ++row) {
        const bool chosen = row == chosen_row;
        if (!chosen && (bridge->built || (bridge->is_branch() && !edit_mode_))) continue;
        views.push_back(views_of({*bridge}).front());
        views.back().chosen = chosen;
        if (bridge->is_branch() && !chosen) views.back().label.clear();
        if (bridge->built)
            views.back().around_mm = std::max(bridge->from_radius_mm, bridge->to_radius_mm);
        drawn_.push_back(row);
    }
    callbacks_.show_bridges(std::move(views));
    const Bridge* chosen = bridge_of(chosen_row);
    callbacks_.look_at(chosen != nullptr ? chosen->path_mm : std::vector<Vec3>());
}

void CaseEditing::set_edit_mode(bool on) {
    if (std::exchange(edit_mode_, on) != on && workspace_.has_patient()) draw_bridges();
}

void CaseEditing::begin_link(const std::optional<Vec3>& from_mm) {
    link_from_mm_ = from_mm;
    callbacks_.link_changed();
}

void CaseEditing::click(const TreePoint& point) {
    if (!workspace_.has_patient() || point.segment < 0) return;
    TreeEdit edit;
    edit.kind = panel_.tool();
    edit.at_mm =
        station_at(workspace_.patient()->tree.segments[static_cast<std::size_t>(point.segment)],
                   point.arclength_mm)
            .position_mm;
    if (gives_system(edit)) edit.system = panel_.system();
    if (edit.kind == TreeEditKind::add_link) {
        if (!link_from_mm_) {
            begin_link(edit.at_mm);
            return callbacks_.say(Words::tr("Now click the vessel to link it with"));
        }
        edit.to_mm = std::exchange(edit.at_mm, *link_from_mm_);
        begin_link({});
    }
    add(edit);
}

void CaseEditing::click_at(const Vec3& place_mm) {
    if (!workspace_.has_patient()) return;
    const VesselTree& tree = workspace_.patient()->tree;
    const TreePoint point = nearest_point(tree, place_mm);
    const double radius_mm =
        station_at(tree.segments[static_cast<std::size_t>(point.segment)], point.arclength_mm)
            .radius_mm;
    if (point.distance_mm > radius_mm + beside_wall_mm)
        return callbacks_.say(
            Words::tr("No vessel there: click on one (by keys: Enter with the cross on it)"));
    click(point);
}

void CaseEditing::click_chosen() {
    if (!workspace_.has_patient()) return;
    const int branch = callbacks_.chosen_branch();
    const std::vector<VesselSegment>& branches = workspace_.patient()->tree.segments;
    if (branch < 0 || branch >= std::ssize(branches))
        return callbacks_.say(Words::tr("Choose a row in the table of branches (F6) first"));
    click({branch, 0.5 * length_mm(branches[static_cast<std::size_t>(branch)])});
}

void CaseEditing::accept(int row) {
    const Bridge* bridge = bridge_of(row);
    if (bridge != nullptr && !bridge->built) callbacks_.add(acceptance_of(*bridge));
}

void CaseEditing::click_drawn(int view) {
    if (view < 0 || view >= std::ssize(drawn_)) return;
    const int row = drawn_[static_cast<std::size_t>(view)];
    if (!edit_mode_) return accept(row);
    panel_.choose_bridge(row);
    callbacks_.say(
        Words::tr("Chosen in the panel Corrections: decide there whether to take or refuse it"));
}

void CaseEditing::refuse(int row) {
    const Bridge* bridge = bridge_of(row);
    if (bridge != nullptr) callbacks_.add(refusal_of(*bridge));
}

void CaseEditing::draw(const Volume& ct, const std::vector<Vec3>& places_mm,
                       const std::optional<double>& radius_mm,
                       const VesselPen::Answered& answered) {
    if (!workspace_.has_patient()) return answered({});
    const std::shared_ptr<const PatientCase> patient = workspace_.patient();
    const auto refuse = [answered, tell = callbacks_.not_drawn](const Failure& failure) {
        tell(failure);
        answered({false, Words::tr("Not drawn: why stands above").toStdString()});
    };
    const double contrast_hu = blood_contrast_hu(ct, patient->tree);
    const std::vector<Vec3> joined = begun_in_vessel(ct, patient->tree, places_mm, contrast_hu);
    // The worker copies its part of the CT, because another CT may be shown before it ends.
    Volume part;
    try {
        part = traced_part(ct, joined);
    } catch (const InputError&) {
        return refuse(failure_of(std::current_exception()));
    }
    BackgroundJob::Callbacks callbacks;
    callbacks.failed = refuse;
    callbacks.ended = [] {};
    drawing_ = std::make_unique<BackgroundJob>(
        [this, patient, part = std::move(part), joined, radius_mm, contrast_hu,
         answered](Job& job) -> std::function<void()> {
            TreeEdit edit = drawing_of(traced_vessel(part, joined, contrast_hu, job));
            if (radius_mm) std::ranges::fill(edit.radii_mm, *radius_mm);
            // Throws now, while the places can still be changed.
            const VesselTree with_it = edited(patient->tree, edit);
            const bool apart = roots(with_it).size() > roots(patient->tree).size();
            return [this, edit, apart, answered] { add_drawn(edit, apart, answered); };
        },
        std::move(callbacks));
}

void CaseEditing::add_drawn(const TreeEdit& edit, bool apart, const VesselPen::Answered& answered) {
    callbacks_.add(edit);
    QString said = Words::tr("A vessel of %L1 mm, radius %L2 mm")
                       .arg(arclengths_mm(edit.path_mm).back(), 0, 'f', 0)
                       .arg(edit.radii_mm[edit.radii_mm.size() / 2], 0, 'f', 1);
    if (apart) said += Words::tr(", apart from all others: begin on a centreline to hang it there");
    answered({true, said.toStdString()});
}

}  // namespace hepatica
