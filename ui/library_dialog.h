// SPDX-License-Identifier: GPL-3.0-or-later
// Library dialog: the cases of a folder with drawings, facts, attempts and lessons. Opens a case,
// begins a lesson on it, copies a case into the folder, and saves one as a single file.
#pragma once

#include <QDialog>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "ui/background_job.h"
#include "ui/case_shelf.h"
#include "ui/settings.h"

class QLabel;
class QListWidget;
class QPushButton;

namespace hepatica {

class CaseLessons;
class MessageBar;

// UI thread only.
class LibraryDialog : public QDialog {
  public:
    // `lacks_work`: not all that the window shows of the case is in what is copied.
    using Copy = std::function<void(bool lacks_work)>;
    struct Ways {
        std::function<void(const QString& place)> open;
        std::function<void(const QString& doing, const Failure&)> failed;
        // Begins the lesson on the patient of that case.
        std::function<void(const ShelvedLesson&, const QString& place)> begin_lesson;
        // Calls `copy` once the case there may be copied: where the window shows it with work that
        // is not saved, the person is asked first whether to save that. May never call it.
        std::function<void(const std::filesystem::path& place, const Copy& copy)> copy_case;
    };
    // `settings` must outlive the dialog.
    LibraryDialog(Settings& settings, Ways ways, QWidget* parent);
    ~LibraryDialog() override;

    // Reads the folder again and shows the dialog.
    void open_library();
    // A case or the result of an attempt was written: reads the folder again, if the dialog is
    // shown.
    void refresh();
    // The cases as last read.
    const std::vector<ShelvedCase>& cases() const { return cases_; }
    bool busy() const { return busy_; }

    // Copies the chosen case with the lessons for it to NAME.hepz, once work on it is saved or is
    // to be left out. Not while busy().
    void give_away(const std::filesystem::path& to);
    // Copies a case into the folder under its own name, and the lessons in its file beside it; if
    // there is a case of that name, says so and offers to keep both. One that lies in the folder is
    // not copied: it is chosen, and only its lessons come beside it. Not while busy().
    void take_in(const std::filesystem::path& from);
    // Reads the folder again, shows the dialog and then takes the case in.
    void open_and_take_in(const std::filesystem::path& from);
    // Whether a case lies in the library's folder.
    bool holds(const std::filesystem::path& place) const;
    // What is said below the cases: failures, and a name that is taken.
    MessageBar& messages() { return *messages_; }

  private:
    void build();
    QWidget* cases_above_messages();
    QLayout* of_chosen_case();
    QWidget* buttons();
    void ask_what_to_take_in();
    void ask_where_to_give();
    void begin(const ShelvedLesson& lesson);
    void choose_folder();
    void read_folder();
    void fill();
    void show_chosen();
    const ShelvedCase* chosen() const;
    // Says beside the buttons, and on those that are grey, what they wait for.
    void show_what_is_under_way();
    void copy(const std::filesystem::path& from, const std::filesystem::path& to);
    void write_one_file(const std::filesystem::path& from, const std::filesystem::path& to,
                        bool lacks_work);
    // At once, or when the job that runs, and what was asked for before, has ended.
    void do_when_idle(std::function<void()> what);
    void do_what_waits();
    // Chooses a case of the folder and puts the lessons in its file beside it.
    void choose_here(const std::filesystem::path& place);
    // A job as a failure names it, and as it is called while it runs.
    struct Doing {
        QString name, under_way;
        bool copies = false;  // it writes, so that the folder is read again also where it fails
    };
    void run(Doing doing, BackgroundJob::Work work);

    Settings& settings_;
    Ways ways_;
    std::vector<ShelvedCase> cases_;
    std::unique_ptr<BackgroundJob> job_;
    bool busy_ = false;
    QString under_way_;                            // while busy
    bool reread_ = false;                          // read the folder when the job has ended
    QString said_;                                 // to be told when the folder was read again
    std::optional<Failure> failed_;                // likewise
    std::deque<std::function<void()>> when_idle_;  // see do_when_idle()
    std::filesystem::path chosen_;                 // chosen again after the folder was read
    QLabel* folder_ = nullptr;
    QListWidget* list_ = nullptr;
    MessageBar* messages_ = nullptr;
    QLabel* facts_ = nullptr;
    CaseLessons* lessons_ = nullptr;
    QPushButton* open_ = nullptr;
    QPushButton* give_ = nullptr;
    QPushButton* take_ = nullptr;
    QPushButton* choose_ = nullptr;
    QLabel* waits_ = nullptr;
};

}  // namespace hepatica
