// SPDX-License-Identifier: GPL-3.0-or-later
// Dialog of the user's recordings with lesson, time and result; recordings elsewhere are chosen in
// a file dialog.
#pragma once

#include <QDialog>
#include <QString>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "ui/background_job.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace hepatica {

// What is known of a recording by its header and what lies beside it.
struct RecordingFacts {
    std::filesystem::path file;
    QString lesson;     // or free play
    QString played;     // date and time, or that they are not known
    QString result;     // may be empty
    QString trainee{};  // may be empty
};
RecordingFacts facts_of(const std::filesystem::path& recording);
// "Gentle pull, 26 Nov 2026, 03:40"
QString title_of(const RecordingFacts& facts);
// Of two that are shown side by side: the number, the result and the title of each, so that what is
// left of a heading where there is little room tells them apart, too; and the file where they are
// alike otherwise. Folders are not named, because saved pictures and films hold the headings and
// folders are often named after the patient.
std::array<QString, 2> headings_of(const RecordingFacts& one, const RecordingFacts& other);

// UI thread only.
class RecordingDialog : public QDialog {
  public:
    // Lists the recordings of the folder, the newest first. If one is `shown` already, another is
    // asked for to compare with, and it is not listed; the newest one of the same patient and
    // lesson is chosen.
    RecordingDialog(const std::filesystem::path& folder, QWidget* parent,
                    std::filesystem::path shown = {});

    // Valid after the dialog was accepted.
    const std::filesystem::path& chosen() const { return chosen_; }

  private:
    void fill();
    int row_to_choose() const;  // -1: none
    // From this row on, one after the other.
    void read_lengths(std::size_t row);
    void choose_row();
    void ask_for_file();

    std::filesystem::path folder_, shown_, chosen_;
    std::vector<RecordingFacts> listed_;
    QLabel* heading_ = nullptr;
    QTableWidget* table_;
    QPushButton* open_;
    std::unique_ptr<BackgroundJob> reading_;
};

}  // namespace hepatica
