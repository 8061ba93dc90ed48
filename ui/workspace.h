// SPDX-License-Identifier: GPL-3.0-or-later
// The open patient: the case whose body is shown, its place on disk, and its corrections with undo
// and redo. A correction is wanted first and gets its body later; this class tracks both, and what
// of them is saved. No widgets; not thread-safe.
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
    // One step of undo or redo: a stroke, the corrections of one deed, or, if both are empty, a
    // rebuild.
    struct Step {
        std::optional<BrushStroke> stroke;
        Edits edits;
    };

    // Replaces the former patient. `series`: see series().
    void open(const OpenedPatient& opened, int series = 0);

    bool has_patient() const { return patient_ != nullptr; }
    const std::string& title() const { return title_; }
    // The case whose body is shown; null before the first patient.
    const std::shared_ptr<const PatientCase>& patient() const { return patient_; }
    // The case on disk; empty: none yet.
    const std::filesystem::path& folder() const { return folder_; }
    // The CT that it was reconstructed from in this run; else empty.
    const std::filesystem::path& image() const { return image_; }
    // Its series that was asked for, numbered from 1 as by list_series(); 0: none was named.
    int series() const { return series_; }

    // The copy of unsaved work that it was opened from; else empty.
    const std::filesystem::path& kept_copy() const { return kept_copy_; }

    // The case on disk that he belongs to: folder(), or the one whose unsaved work was recovered;
    // empty: none.
    const std::filesystem::path& home() const { return folder_.empty() ? recovered_ : folder_; }
    // digest_of_case() of home() as it was opened or last saved, here or by the program whose
    // unsaved work this is; empty: not known.
    const std::string& digest() const { return digest_; }
    void set_digest(std::string digest) { digest_ = std::move(digest); }
    // His unsaved work is that of this case; empty: of none.
    void set_recovered(const std::filesystem::path& place) { recovered_ = place; }

    // A case on disk on which the corrections can be repeated; empty: none.
    const std::filesystem::path& base() const { return base_; }
    // Changes with every patient and every rebuild: corrections belong to one origin.
    std::uint64_t origin() const { return origin_; }
    // Changes with every patient alone.
    std::uint64_t opening() const { return opened_origin_; }
    // The vessels were rebuilt since he was opened.
    bool remade() const { return origin_ != opened_origin_; }

    // --- corrections; these need an open patient ---
    const Edits& edits() const { return edits_; }  // the wanted ones
    // Whether wanted corrections have no body yet. Strokes at tumours need none.
    bool awaits_body() const;
    // Corrections included in the body, and wanted strokes at tumours: what can be saved.
    Edits made_edits() const;
    // The next step of undo and redo; nullopt: none.
    std::optional<Step> next_undo() const;
    std::optional<Step> next_redo() const;
    // The next undo takes back a correction from before a rebuilding that stays: of one that was
    // done before he was opened the voxels from before are not kept.
    bool undo_passes_rebuilding() const;
    void add(const TreeEdit& edit) { add_all({edit}); }
    // These are one step of undo and redo.
    void add_all(Edits added);
    // Replaces corrections, pending strokes and, where it knows them, measurements by those that an
    // earlier run left.
    void take_up(const LeftEdits& left);
    // Undoes the corrections of the last step; returns whether that changes the tree. No effect if
    // there is none or the last step was a rebuild.
    bool undo();
    bool redo();  // likewise
    // The body is now this one; wanted corrections that it lacks were refused.
    void show_body(std::shared_ptr<const PatientCase> patient);
    // The vessels were rebuilt: `before`, with all voxels, became `patient`, with the corrections
    // that could be repeated. Corrections added since the rebuild began stay wanted. The first
    // `strokes` pending strokes are in the vessels now.
    // `warnings` replace all but those of the image.
    void show_remade(std::shared_ptr<const PatientCase> before,
                     std::shared_ptr<const PatientCase> patient, std::size_t strokes = 0,
                     std::vector<std::string> warnings = {});
    // The patient from before the rebuild, if that is the next step to undo; else null.
    std::shared_ptr<const PatientCase> before_remaking() const;
    // Returns to before_remaking(), if that is not null.
    void take_back_remaking();
    // The rebuilt patient, if the next step to redo is a rebuild that was taken back; else null.
    std::shared_ptr<const PatientCase> remaking_again() const;
    // Returns to remaking_again(), if that is not null. Its strokes are in the vessels again, and
    // what was undone after it can be redone.
    void redo_remaking();
    struct GivenUp {
        std::size_t steps = 0;  // that can be redone by that
        std::size_t lost = 0;   // that could be redone, but not after what is there again
    };
    // The body that is being made will not come. Corrections that the shown body lacks are taken
    // back and can be redone, in their order; if something was undone before them, that still
    // awaits its body. Where only undone ones wait, these are there again, and nothing waits.
    GivenUp give_up_edits();

    // --- strokes at the vessel mask, which wait for a rebuild ---
    const std::vector<PendingStroke>& strokes() const { return strokes_.made(); }
    void add_stroke(const BrushStroke& stroke);
    // Whether the next undo or redo is of a stroke.
    bool undo_is_of_stroke() const { return strokes_.undo_is_mine(edits_.size()); }
    bool redo_is_of_stroke() const { return strokes_.redo_is_mine(edits_.size()); }
    void undo_stroke();  // the last one, whatever was corrected since
    void redo_stroke();
    // Changes with every stroke that is added, undone, redone or rebuilt.
    std::uint64_t strokes_version() const { return strokes_version_; }

    // --- warnings ---
    // As far as they still hold; see standing_warnings.h.
    const std::vector<std::string>& warnings() const { return warnings_; }
    void set_warnings(std::vector<std::string> warnings) { warnings_ = std::move(warnings); }

    // --- measurements of the patient, by hand ---
    const std::vector<KeptMeasurement>& measured() const { return measured_; }
    // False where it is the same.
    bool measure(std::vector<KeptMeasurement> measured);

    // --- disk ---
    // dirty(): corrections, measurements or a reconstruction are not saved. unsaved(): or strokes
    // are pending, which no case can hold.
    bool dirty() const {
        return never_saved_ || edits_ != saved_edits_ || measured_ != saved_measured_;
    }
    bool unsaved() const { return dirty() || !strokes_.empty(); }
    // The case was written there with these corrections and measurements.
    void saved(const std::filesystem::path& folder, const Edits& edits,
               const std::vector<KeptMeasurement>& measured);
    // Changes with every patient and every change of the wanted corrections.
    std::uint64_t version() const { return version_; }

  private:
    struct Remaking {
        std::shared_ptr<const PatientCase> before, after;
        bool was_never_saved = false;
        std::vector<PendingStroke> strokes;  // that it was made of
        // From before; of one that was taken back, from after it.
        std::vector<std::string> warnings;
        std::vector<Edits> undone;  // of one that was taken back: steps after it
    };
    // That can be undone; each holds a whole patient.
    static constexpr std::size_t most_remakings = 5;

    void want(Edits edits);
    void forget_undone();
    // These corrections, which were undone, are there again: takes them out of what can be redone.
    // If something else was done after they were undone, no redo of the tree fits any more; returns
    // how many steps are lost by that.
    std::size_t take_from_undone(const Edits& again);
    void show_other(std::shared_ptr<const PatientCase> patient);
    Edits added_since(const Edits& begun_with) const;

    std::string title_;
    std::shared_ptr<const PatientCase> patient_;
    std::filesystem::path folder_;
    std::string digest_;  // see digest()
    std::filesystem::path image_;
    int series_ = 0;
    std::filesystem::path kept_copy_;
    std::filesystem::path recovered_;  // see home()
    std::filesystem::path base_;
    Edits edits_;
    std::vector<Edits> undone_;  // steps; the last one is redone first
    Edits saved_edits_;
    std::vector<KeptMeasurement> measured_, saved_measured_;
    bool never_saved_ = false;  // although it should be saved
    std::vector<std::string> warnings_, warnings_of_image_;
    std::vector<Remaking> remade_, taken_back_;
    PendingStrokes strokes_;
    std::uint64_t strokes_version_ = 0;
    std::uint64_t version_ = 0;
    std::uint64_t origin_ = 0, opened_origin_ = 0;
};

}  // namespace hepatica
