// SPDX-License-Identifier: GPL-3.0-or-later
// Corrections on disk as soon as they are wanted, long before their body is there: JSON lines that
// are only appended and synchronised with the disk, so that a program that dies leaves every one.
// A base says from which case they can be made again; a line after it, how many of those before
// stay and what comes behind them, which says undo and redo, too.
//   {"format": "hepatica-edits", "version": 1, "title": "anton.hep", "case": "/data/anton.hep",
//    "extracted": "0123456789abcdef"}
//   {"change": 7, "keep": 2, "add": [{"kind": "cut_link", ...}]}
// A third kind of line says which strokes at vessels wait for a remaking, in the same way:
//   {"keep_strokes": 1, "add_strokes": [{"path_mm": ...}]}
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

#include "core/patient/pending_stroke.h"
#include "core/tree/editing/tree_edit.h"

namespace hepatica {

// What the corrections of a journal were made on.
struct JournalBase {
    std::string title;
    // A case; empty: the built-in patient; ".": the newest whole copy beside the journal.
    std::filesystem::path place;
    std::uint64_t extracted = 0;  // hash_of_extracted() of the patient
    bool operator==(const JournalBase&) const = default;
};

// The newest that a journal says.
struct Journalled {
    JournalBase base;
    std::vector<TreeEdit> edits;         // all that were wanted
    std::vector<PendingStroke> strokes;  // that waited for a remaking
    std::uint64_t change = 0;            // number of the newest change
    bool operator==(const Journalled&) const = default;
};

// What stands in a journal up to its first damaged line, which a torn last one is. None where it
// holds no base or no change. Never throws for what the file holds.
std::optional<Journalled> read_edit_journal(const std::filesystem::path& file);

// One thread appends; the file is written on another, which nobody waits for but the destructor.
class EditJournal {
  public:
    // The file is made with the first line.
    explicit EditJournal(std::filesystem::path file);
    ~EditJournal();  // all that was appended is on disk
    EditJournal(const EditJournal&) = delete;
    EditJournal& operator=(const EditJournal&) = delete;

    // Of the base all these corrections are wanted now, and all these strokes wait. Nothing is
    // written where the journal says so already.
    void append(const Journalled& wanted);
    // Returns when all that was appended is on disk, or could not be written.
    void wait_until_written();
    // Whether a line could not be written. Any thread.
    bool failed() const { return failed_; }

  private:
    void write_until_closed();

    std::filesystem::path file_;
    std::optional<Journalled> said_;
    std::mutex mutex_;  // guards waiting_, writing_ and closing_
    std::string waiting_;
    bool writing_ = false;
    bool closing_ = false;
    std::condition_variable changed_;
    std::atomic<bool> failed_ = false;
    std::jthread thread_;
};

}  // namespace hepatica
