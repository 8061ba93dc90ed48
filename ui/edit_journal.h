// SPDX-License-Identifier: GPL-3.0-or-later
// Journal of corrections and measurements, written as soon as they are made: JSON lines that are
// appended and synchronised with the disk, so that none is lost if the program dies. A base line
// names the case that they apply to; each change line tells how many of the previous corrections
// stay ("keep", fewer after an undo) and which follow them:
//   {"format": "hepatica-edits", "version": 1, "title": "anton.hep", "case": "/data/anton.hep",
//    "extracted": "0123456789abcdef"}
// Where "case" is a copy, "copy_of" may name the case on disk that the copy was made of.
//   {"change": 7, "keep": 2, "add": [{"edit": "cut_link", ...}]}
// A third kind of line does the same for the strokes that wait for a rebuild:
//   {"keep_strokes": 1, "add_strokes": [{"path_mm": ...}]}
// Where measurements changed, a change line also says how many of them stay and which follow, as in
// measurements.json (core/patient/measurement.h). Programs that know none ignore these two:
//   {"change": 8, "keep": 3, "add": [], "keep_measured": 1, "add_measured": {"format": ...}}
// After a line that was cut off, as on a full disk, the next one is a base line, and the lines
// after it start from no corrections, strokes and measurements.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/patient/measurement.h"
#include "core/patient/pending_stroke.h"
#include "core/tree/editing/tree_edit.h"

namespace hepatica {

// What the corrections of a journal apply to.
struct JournalBase {
    std::string title;
    // A case; empty: the built-in patient; ".": the newest complete copy beside the journal.
    std::filesystem::path place;
    std::uint64_t extracted = 0;  // hash_of_extracted() of the patient
    // Of a copy: the case on disk whose unsaved work it holds; empty: none.
    std::filesystem::path copy_of{};
    // digest_of_case() of the case on disk as it was opened or last saved; empty: not known.
    std::string digest{};
    bool operator==(const JournalBase&) const = default;
};

// The newest state in a journal.
struct Journalled {
    JournalBase base;
    std::vector<TreeEdit> edits;         // all present corrections
    std::vector<PendingStroke> strokes;  // waiting for a rebuild
    std::uint64_t change = 0;            // number of the newest change
    // All present measurements; nullopt: the journal does not say, so those of the base hold.
    std::optional<std::vector<KeptMeasurement>> measured{};
    bool operator==(const Journalled&) const = default;
};

// What of a journal is not in the newest state that was read.
struct JournalLoss {
    enum class Kind {
        none,
        end,   // the last line, which was being written
        line,  // a damaged line and those behind it
        read,  // the lines from where a read failed
    };
    Kind kind = Kind::none;
    int line = 0;  // number of the damaged one, from 1
    bool operator==(const JournalLoss&) const = default;
};

// Reads a journal without the lines from a damaged one to the next base line, and without those
// from where a read fails: corrections before it are worth more than a refusal. `loss`, if not
// null, is told which these are, unless a later base line says all of it again. nullopt if there is
// no change with a base. Never throws because of the file's content.
std::optional<Journalled> read_edit_journal(const std::filesystem::path& file,
                                            JournalLoss* loss = nullptr);

// One thread appends; another writes the file, and only the destructor waits for it.
class EditJournal {
  public:
    // The file is created with the first line.
    explicit EditJournal(std::filesystem::path file);
    ~EditJournal();  // waits until everything is written
    EditJournal(const EditJournal&) = delete;
    EditJournal& operator=(const EditJournal&) = delete;

    // These are now the corrections, strokes and measurements on this base. Writes nothing if they
    // equal the last ones and those are written.
    void append(const Journalled& wanted);
    // Waits until the last ones are on disk or could not be written.
    void wait_until_written();
    // Whether the last ones could not be written; the next append() tries again. Any thread.
    bool failed() const { return failed_; }

  private:
    void write_until_closed();

    std::filesystem::path file_;
    std::optional<Journalled> said_;
    std::mutex mutex_;  // guards waiting_, writing_ and closing_
    std::optional<Journalled> waiting_;
    bool writing_ = false;
    bool closing_ = false;
    std::condition_variable changed_;
    std::atomic<bool> failed_ = false;
    std::jthread thread_;
};

}  // namespace hepatica
