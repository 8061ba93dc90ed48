// SPDX-License-Identifier: GPL-3.0-or-later
// The patient that is open: the case whose body is shown, where it lies on disk, and its
// corrections with what can be undone. A correction is wanted first and has a body later; this
// class knows both, and what of them is on disk. No toolkit; not thread-safe.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/opening/open_patient.h"
#include "core/patient/patient_case.h"

namespace hepatica {

class Workspace {
  public:
    using Edits = std::vector<TreeEdit>;

    // Forgets the patient that was open before.
    void open(const OpenedPatient& opened);

    bool has_patient() const { return patient_ != nullptr; }
    const std::string& title() const { return title_; }
    // The case whose body is shown: with shown_edits(). Null before the first patient.
    const std::shared_ptr<const PatientCase>& patient() const { return patient_; }
    // The case on disk; empty: nowhere yet.
    const std::filesystem::path& folder() const { return folder_; }
    // The CT that it was reconstructed from since the program began; else empty.
    const std::filesystem::path& image() const { return image_; }

    // --- corrections
    // ------------------------------------------------------------------------------
    const Edits& edits() const { return history_.back().edits; }
    const Edits& shown_edits() const { return history_.front().edits; }
    // The wanted corrections have no body yet.
    bool awaits_body() const { return history_.size() > 1; }
    bool can_undo() const { return !edits().empty(); }
    bool can_redo() const { return !history_.back().undone.empty(); }
    void add(const TreeEdit& edit);
    void undo();  // nothing where there is nothing to undo
    void redo();  // likewise

    // The lists to make a body of, the wanted one first. Where it cannot be made, the one that was
    // wanted before it is the next best: one impossible correction does not take others with it.
    std::vector<Edits> attempts() const;
    // One of attempts() has its body now: those before it in that list were impossible.
    void show_body(std::shared_ptr<const PatientCase> patient);
    // None of them will have a body: back to the corrections that are shown.
    void give_up_edits();

    // --- disk
    // -------------------------------------------------------------------------------------
    // Something would be lost without saving: corrections, or a reconstruction.
    bool dirty() const;
    // The case was written there with these corrections.
    void saved(const std::filesystem::path& folder, const Edits& edits);
    // Changes with every patient and every correction.
    std::uint64_t version() const { return version_; }

  private:
    struct Step {
        Edits edits;
        Edits undone;  // the last one is the first to be done again
    };
    void want(Step step);

    std::string title_;
    std::shared_ptr<const PatientCase> patient_;
    std::filesystem::path folder_;
    std::filesystem::path image_;
    // Never empty: the corrections that are shown, then each list that was wanted since.
    std::vector<Step> history_{Step{}};
    Edits saved_edits_;
    bool never_saved_ = false;  // although it should be
    std::uint64_t version_ = 0;
};

}  // namespace hepatica
