// SPDX-License-Identifier: GPL-3.0-or-later
// The patient that is open: the case whose body is shown, where it lies on disk, and its
// corrections with what can be undone. A correction is wanted first and has a body later; this
// class knows both, and what of them is on disk. No toolkit; not thread-safe.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/opening/open_patient.h"
#include "core/patient/patient_case.h"
#include "ui/pending_strokes.h"

namespace hepatica {

class Workspace {
  public:
    using Edits = std::vector<TreeEdit>;
    // What undo or redo would do next: a stroke, a correction, or neither, which is a remaking.
    struct Step {
        std::optional<BrushStroke> stroke;
        std::optional<TreeEdit> edit;
    };

    // Forgets the patient that was open before.
    void open(const OpenedPatient& opened);

    bool has_patient() const { return patient_ != nullptr; }
    const std::string& title() const { return title_; }
    // The case whose body is shown. Null before the first patient.
    const std::shared_ptr<const PatientCase>& patient() const { return patient_; }
    // The case on disk; empty: nowhere yet.
    const std::filesystem::path& folder() const { return folder_; }
    // The CT that it was reconstructed from since the program began; else empty.
    const std::filesystem::path& image() const { return image_; }

    // The copy of unsaved work that it was opened from; else empty.
    const std::filesystem::path& kept_copy() const { return kept_copy_; }

    // A case on disk on which the corrections can be made again; empty: there is none.
    const std::filesystem::path& base() const { return base_; }
    // Changes with every patient and every remaking: corrections belong to one origin.
    std::uint64_t origin() const { return origin_; }
    // The vessels are others than when he was opened.
    bool remade() const { return origin_ != opened_origin_; }

    // --- corrections: of an open patient only
    // -----------------------------------------------------
    const Edits& edits() const { return edits_; }  // that are wanted
    // They have no body yet. Strokes at tumours need none.
    bool awaits_body() const;
    // Those that the body has, and the strokes at tumours that are wanted: what can be written.
    Edits made_edits() const;
    std::optional<Step> next_undo() const;
    std::optional<Step> next_redo() const;
    // The next undo takes back a correction from before a rebuilding that stays: of one that was
    // done before he was opened the voxels from before are not kept.
    bool undo_passes_rebuilding() const;
    bool can_undo() const { return next_undo().has_value(); }
    bool can_redo() const { return next_redo().has_value(); }
    void add(const TreeEdit& edit);
    // In place of all others, as a program left them, and the strokes that waited.
    void take_up(const Edits& edits, std::vector<PendingStroke> strokes);
    // Nothing where there is nothing to undo, or where the last was a remaking. Whether that
    // changes the tree.
    bool undo();
    bool redo();  // likewise
    // This body is there, and what is not among its corrections was refused.
    void show_body(std::shared_ptr<const PatientCase> patient);
    // The patient was made anew from other voxels of his vessels: `before`, with all his voxels,
    // became `patient`, whose corrections are those that could be made again. Corrections that were
    // added since it began stay wanted. The first `strokes` of those that waited are in the vessels
    // now. `warnings` take the place of all but those of the image.
    void show_remade(std::shared_ptr<const PatientCase> before,
                     std::shared_ptr<const PatientCase> patient, std::size_t strokes = 0,
                     std::vector<std::string> warnings = {});
    // The next undo would take that back, to the patient from before; null: it would not.
    std::shared_ptr<const PatientCase> before_remaking() const;
    void take_back_remaking();
    // There will be no other body: back to the corrections that are shown.
    void give_up_edits();

    // --- strokes at the vessels' voxels, which wait for a remaking
    // -------------------------------------
    const std::vector<PendingStroke>& strokes() const { return strokes_.made(); }
    void add_stroke(const BrushStroke& stroke);
    // The next undo or redo is of a stroke, and what that does.
    bool undo_is_of_stroke() const { return strokes_.undo_is_mine(edits_.size()); }
    bool redo_is_of_stroke() const { return strokes_.redo_is_mine(edits_.size()); }
    void undo_stroke();  // the last one, whatever was corrected since
    void redo_stroke();
    // Changes with every stroke that is led, taken back or made into vessels.
    std::uint64_t strokes_version() const { return strokes_version_; }

    // --- what is to be warned of, as far as it still holds; see standing_warnings.h
    // ---------------------------------------------------------------------------------------
    const std::vector<std::string>& warnings() const { return warnings_; }
    void set_warnings(std::vector<std::string> warnings) { warnings_ = std::move(warnings); }

    // --- what a person measured on him
    // --------------------------------------------------------------
    const std::vector<KeptMeasurement>& measured() const { return measured_; }
    // False where it is the same.
    bool measure(std::vector<KeptMeasurement> measured);

    // --- disk
    // -------------------------------------------------------------------------------------
    // Something would be lost without saving: corrections, measurements, or a reconstruction.
    // Strokes that wait are lost even so: they are in no case.
    bool dirty() const {
        return never_saved_ || edits_ != saved_edits_ || measured_ != saved_measured_;
    }
    bool unsaved() const { return dirty() || !strokes_.empty(); }
    // The case was written there with these corrections and measurements.
    void saved(const std::filesystem::path& folder, const Edits& edits,
               const std::vector<KeptMeasurement>& measured);
    // Changes with every patient and with every change of what is wanted.
    std::uint64_t version() const { return version_; }

  private:
    struct Remaking {
        std::shared_ptr<const PatientCase> before;
        std::size_t edits = 0;  // of the remade patient
        bool was_never_saved = false;
        std::vector<PendingStroke> strokes;  // that it was made of
        std::vector<std::string> warnings;   // from before
    };
    static constexpr std::size_t most_remakings = 5;  // that are kept: each holds a whole patient

    void want(Edits edits);

    std::string title_;
    std::shared_ptr<const PatientCase> patient_;
    std::filesystem::path folder_;
    std::filesystem::path image_;
    std::filesystem::path kept_copy_;
    std::filesystem::path base_;
    Edits edits_;
    Edits undone_;  // the last one is the first to be done again
    Edits saved_edits_;
    std::vector<KeptMeasurement> measured_, saved_measured_;
    bool never_saved_ = false;  // although it should be
    std::vector<std::string> warnings_, warnings_of_image_;
    std::vector<Remaking> remade_;
    PendingStrokes strokes_;
    std::uint64_t strokes_version_ = 0;
    std::uint64_t version_ = 0;
    std::uint64_t origin_ = 0, opened_origin_ = 0;
};

}  // namespace hepatica
