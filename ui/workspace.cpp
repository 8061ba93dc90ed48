// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workspace.h"

#include <algorithm>
#include <iterator>
#include <ranges>
#include <utility>

#include "core/patient/corrections.h"
#include "core/patient/painted_tumours.h"

namespace hepatica {

namespace {

// The last of these, with those before it that were made with it, taken out of `from`.
Workspace::Edits take_last_step(Workspace::Edits& from) {
    auto begin = from.end() - 1;
    while (begin != from.begin() && of_one_step(*(begin - 1), *begin)) --begin;
    Workspace::Edits taken(begin, from.end());
    from.erase(begin, from.end());
    return taken;
}

// `from` without these, which are its last corrections of the tree.
Workspace::Edits without_last(Workspace::Edits from, const Workspace::Edits& these) {
    for (auto edit = these.rbegin(); edit != these.rend(); ++edit)
        if (const auto found = std::find(from.rbegin(), from.rend(), *edit); found != from.rend())
            from.erase(std::next(found).base());
    return from;
}

bool change_tree(const Workspace::Edits& edits) {
    return std::ranges::any_of(edits, changes_tree, &TreeEdit::kind);
}

}  // namespace

void Workspace::open(const OpenedPatient& opened, int series) {
    title_ = opened.title;
    patient_ = opened.patient;
    folder_ = opened.folder;
    digest_.clear();
    image_ = opened.image;
    series_ = series;
    kept_copy_ = opened.kept_copy;
    recovered_.clear();
    base_ = opened.read_from.empty() ? opened.folder : opened.read_from;
    opened_origin_ = ++origin_;
    saved_edits_ = patient_->corrections.edits;
    measured_ = saved_measured_ = patient_->measured;
    never_saved_ = opened.worth_saving;
    warnings_ = opened.warnings;
    warnings_of_image_ = opened.warnings_of_image;
    undone_.clear();
    taken_back_.clear();
    remade_.clear();
    strokes_ = {};
    ++strokes_version_;
    want(saved_edits_);
}

void Workspace::take_up(const LeftEdits& left) {
    taken_back_.clear();
    strokes_ = PendingStrokes(left.strokes);
    ++strokes_version_;
    if (left.measured) measured_ = *left.measured;
    want(left.edits);
}

void Workspace::want(Edits edits) {
    edits_ = std::move(edits);
    ++version_;
}

void Workspace::forget_undone() {
    undone_.clear();
    taken_back_.clear();
}

void Workspace::add_all(Edits added) {
    if (added.size() > 1) {
        const int step = next_step(edits_);
        for (TreeEdit& edit : added) edit.step = step;
    }
    Edits edits = edits_;
    std::ranges::move(added, std::back_inserter(edits));
    forget_undone();
    strokes_.forget_undone();
    want(std::move(edits));
}

void Workspace::add_stroke(const BrushStroke& stroke) {
    forget_undone();
    strokes_.add(stroke, edits_.size());
    ++strokes_version_;
}

void Workspace::undo_stroke() {
    strokes_.undo();
    ++strokes_version_;
}

void Workspace::redo_stroke() {
    strokes_.redo();
    ++strokes_version_;
}

std::optional<Workspace::Step> Workspace::next_undo() const {
    if (undo_is_of_stroke()) return Step{strokes_.made().back().stroke, {}};
    if (before_remaking() != nullptr) return Step{};
    if (edits_.empty()) return std::nullopt;
    Edits edits = edits_;
    return Step{std::nullopt, take_last_step(edits)};
}

bool Workspace::undo_passes_rebuilding() const {
    if (edits_.empty() || undo_is_of_stroke() || before_remaking() != nullptr) return false;
    const std::vector<Rebuilding> rebuilt = rebuildings_among(edits_, patient_->corrections);
    const std::size_t to_stay = rebuilt.size() - std::min(rebuilt.size(), remade_.size());
    return std::any_of(rebuilt.begin(), rebuilt.begin() + static_cast<std::ptrdiff_t>(to_stay),
                       [this](const Rebuilding& one) { return one.after_edits >= edits_.size(); });
}

std::optional<Workspace::Step> Workspace::next_redo() const {
    if (redo_is_of_stroke()) return Step{strokes_.next_again(), {}};
    if (remaking_again() != nullptr) return Step{};
    if (undone_.empty()) return std::nullopt;
    return Step{std::nullopt, undone_.back()};
}

bool Workspace::undo() {
    if (edits_.empty() || before_remaking() != nullptr) return false;
    Edits edits = edits_;
    undone_.push_back(take_last_step(edits));
    want(std::move(edits));
    return change_tree(undone_.back());
}

bool Workspace::redo() {
    if (undone_.empty()) return false;
    const Edits again = std::move(undone_.back());
    undone_.pop_back();
    Edits edits = edits_;
    edits.insert(edits.end(), again.begin(), again.end());
    want(std::move(edits));
    return change_tree(again);
}

bool Workspace::awaits_body() const {
    return has_patient() && tree_edits(edits_) != tree_edits(patient_->corrections.edits);
}

Workspace::Edits Workspace::made_edits() const {
    if (!awaits_body()) return edits_;
    const Edits body = tree_edits(patient_->corrections.edits);
    Edits made;
    auto next = body.begin();
    for (const TreeEdit& edit : edits_) {
        if (!changes_tree(edit.kind)) {
            made.push_back(edit);
        } else if (const auto found = std::find(next, body.end(), edit); found != body.end()) {
            made.insert(made.end(), next, found + 1);
            next = found + 1;
        }
    }
    made.insert(made.end(), next, body.end());
    return made;
}

void Workspace::show_body(std::shared_ptr<const PatientCase> patient) {
    patient_ = std::move(patient);
    if (awaits_body()) want(made_edits());
}

// Those of the wanted corrections that a rebuilding did not begin with, in their order: one that
// had no body yet may stand before one that needs none.
Workspace::Edits Workspace::added_since(const Edits& begun_with) const {
    Edits added;
    auto next = begun_with.begin();
    for (const TreeEdit& edit : edits_)
        next != begun_with.end() && *next == edit ? void(++next) : added.push_back(edit);
    return next == begun_with.end() ? added : Edits();
}

void Workspace::show_remade(std::shared_ptr<const PatientCase> before,
                            std::shared_ptr<const PatientCase> patient, std::size_t strokes,
                            std::vector<std::string> warnings) {
    Edits wanted = patient->corrections.edits;
    const Edits added = added_since(before->corrections.edits);
    wanted.insert(wanted.end(), added.begin(), added.end());
    if (remade_.size() == most_remakings) remade_.erase(remade_.begin());
    remade_.push_back({std::move(before),
                       patient,
                       never_saved_,
                       strokes_.take_first(strokes, wanted.size()),
                       std::move(warnings_),
                       {}});
    warnings_ = std::move(warnings);
    warnings_.insert(warnings_.end(), warnings_of_image_.begin(), warnings_of_image_.end());
    ++strokes_version_;
    forget_undone();
    never_saved_ = true;
    show_other(std::move(patient));
    want(std::move(wanted));
}

// One with other vessels, on which nothing on disk can be repeated.
void Workspace::show_other(std::shared_ptr<const PatientCase> patient) {
    patient_ = std::move(patient);
    base_.clear();
    ++origin_;
    want(patient_->corrections.edits);
}

std::shared_ptr<const PatientCase> Workspace::before_remaking() const {
    if (remade_.empty() || edits_.size() > remade_.back().after->corrections.edits.size())
        return nullptr;
    return remade_.back().before;
}

void Workspace::take_back_remaking() {
    if (before_remaking() == nullptr) return;
    Remaking remaking = std::move(remade_.back());
    remade_.pop_back();
    never_saved_ = remaking.was_never_saved;
    strokes_.put_back(remaking.strokes);
    ++strokes_version_;
    std::swap(warnings_, remaking.warnings);
    remaking.undone = std::move(undone_);
    undone_.clear();
    show_other(remaking.before);
    taken_back_.push_back(std::move(remaking));
}

std::shared_ptr<const PatientCase> Workspace::remaking_again() const {
    if (taken_back_.empty() || !undone_.empty()) return nullptr;
    const Remaking& last = taken_back_.back();
    const bool as_it_began =
        edits_ == last.before->corrections.edits && strokes_.made() == last.strokes;
    return as_it_began ? last.after : nullptr;
}

void Workspace::redo_remaking() {
    if (remaking_again() == nullptr) return;
    Remaking remaking = std::move(taken_back_.back());
    taken_back_.pop_back();
    remaking.was_never_saved = std::exchange(never_saved_, true);
    strokes_.take_first(remaking.strokes.size(), remaking.after->corrections.edits.size());
    ++strokes_version_;
    std::swap(warnings_, remaking.warnings);
    undone_ = std::move(remaking.undone);
    show_other(remaking.after);
    remade_.push_back(std::move(remaking));
}

Workspace::GivenUp Workspace::give_up_edits() {
    if (!awaits_body()) return {};
    const Edits body = tree_edits(patient_->corrections.edits);
    const Edits wanted = tree_edits(edits_);
    auto [undone, younger] = std::ranges::mismatch(body, wanted);
    while (younger != wanted.begin() && younger != wanted.end() &&
           of_one_step(*std::prev(younger), *younger)) {
        --undone;
        --younger;
    }
    GivenUp given_up;
    if (younger == wanted.end()) {
        given_up.lost = take_from_undone(Edits(undone, body.end()));
        want(made_edits());
        return given_up;
    }
    Edits waiting(younger, wanted.end());
    want(without_last(edits_, waiting));
    for (; !waiting.empty(); ++given_up.steps) undone_.push_back(take_last_step(waiting));
    return given_up;
}

std::size_t Workspace::take_from_undone(const Edits& again) {
    auto next = again.begin();
    for (auto step = undone_.end(); step != undone_.begin() && next != again.end();) {
        const Edits of_tree = tree_edits(*--step);
        if (of_tree.empty()) continue;
        const Edits rest(next, again.end());
        if (!std::ranges::equal(of_tree, rest | std::views::take(of_tree.size()))) break;
        next += static_cast<std::ptrdiff_t>(of_tree.size());
        step = undone_.erase(step);
    }
    return next == again.end() ? 0 : std::erase_if(undone_, change_tree);
}

bool Workspace::measure(std::vector<KeptMeasurement> measured) {
    if (measured == measured_) return false;
    measured_ = std::move(measured);
    ++version_;
    return true;
}

void Workspace::saved(const std::filesystem::path& folder, const Edits& edits,
                      const std::vector<KeptMeasurement>& measured) {
    base_ = folder_ = folder;
    digest_.clear();
    title_ = folder.filename().string();
    saved_edits_ = edits;
    saved_measured_ = measured;
    never_saved_ = false;
    // The states before a rebuild are no longer on disk.
    for (Remaking& remaking : remade_) remaking.was_never_saved = true;
}

}  // namespace hepatica
