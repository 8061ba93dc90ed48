// SPDX-License-Identifier: GPL-3.0-or-later
// Looking back on a recording: its time line with what happened, speed, jumps, and the instructor's
// notes, which lie beside it. The window lends its patient and takes the tape for a simulation.
#pragma once

#include <QDockWidget>
#include <QElapsedTimer>
#include <QTimer>
#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/lesson/lesson.h"
#include "core/lesson/play_meter.h"
#include "core/lesson/play_notes.h"
#include "core/lesson/review_tape.h"
#include "core/opening/open_patient.h"
#include "core/session/recording.h"
#include "render/mark_actors.h"
#include "ui/background_job.h"
#include "ui/simulation.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QToolButton;

namespace hepatica {

class ReviewList;
class TimeLine;
struct ReviewScreen;

class ReviewDock : public QDockWidget {
  public:
    struct Ways {
        // The patient that is shown; null: none.
        std::function<std::shared_ptr<const PatientCase>()> patient;
        std::function<void(const OpenRequest&)> open;  // shows it some time later: patient_shown()
        // That a recording names. On any thread; throws InputError where it is not to be had.
        std::function<DeformBackEnd(const std::string& name)> back_end = [](const std::string&) {
            return cpu_back_end();
        };
        // In place of the simulation that runs; null: that of free play.
        std::function<void(std::unique_ptr<Simulation>)> use;
        // Another recording, to be shown beside; none: not after all.
        std::function<std::optional<std::filesystem::path>()> ask_for_other;
        // A frame beside the first view, the lesson's marks in it, and what both are called; null:
        // nothing any more.
        std::function<void(const std::shared_ptr<const Frame>& frame, std::vector<MarkView> marks,
                           const QString& first, const QString& other)>
            beside;
        // Makes a film of it: `go_to` shows a moment.
        std::function<void(double end_s, const std::function<void(double at_s)>& go_to)> save_film;
        // The case of a patient with this hash, where these settings know it; else empty.
        std::function<std::filesystem::path(std::uint64_t hash)> known_case = [](std::uint64_t) {
            return std::filesystem::path();
        };
        // Says what failed, and lets the person choose the case in question.
        std::function<void(const Failure&, std::function<void(const std::filesystem::path&)>)>
            choose_case =
                [](const Failure&, const std::function<void(const std::filesystem::path&)>&) {};
        std::function<bool()> lesson_runs;  // which a review would end
        std::function<void(const Failure&)> failed;
        std::function<void(const QString&)> say;  // in passing
    };

    ReviewDock(Ways ways, QWidget* parent);
    ~ReviewDock() override;

    // Reads the recording and looks for its patient: the one that is shown, a case beside it, or
    // the built-in one where its lesson is played on him. Then shows it from the beginning, while
    // the rest is still gone through. `lesson`: file or name; empty: the built-in one with that
    // scene, if any.
    void open(const std::filesystem::path& recording, const std::string& lesson = {});
    // Nothing is shown or read any more; the simulation stays as it is.
    void end() { forget(); }
    // The patient that was being opened does not come: a recording that waits for him is let go of.
    void patient_not_shown();
    // There is another patient now: a recording that waited for him begins, one of another ends.
    void patient_shown();
    // Shows another recording of the same patient beside it, both from their beginnings.
    void compare(const std::filesystem::path& other);
    bool comparing() const { return other_tape_ != nullptr; }
    // The recording is shown now.
    bool reviewing() const { return screen_ != nullptr; }
    // Every frame of it, and of one beside it, has been gone through.
    bool complete() const { return reviewing() && job_ == nullptr && other_job_ == nullptr; }

    // A recording is being read, waits for its patient or is gone through.
    bool busy() const { return waits_ || (job_ != nullptr && !complete()); }
    // The lesson's marks in a frame of it, as they stood at the moment that is shown; none where it
    // is of no lesson.
    std::vector<MarkView> marks_in(const Frame& frame) const;
    double at_s() const { return at_s_; }
    bool playing() const { return clock_.isActive(); }

    // The recording that is or was looked back on last.
    const std::filesystem::path& file() const { return file_; }

  private:
    std::vector<MarkView> marks_in(const Frame& frame, const ReviewTape& tape) const;
    struct Found;  // a recording that was read, with what it needs
    void build();
    QWidget* build_heading();
    QWidget* build_controls();
    QWidget* build_notes();
    void take(Found found);
    void open_case(const std::filesystem::path& place);
    void ask_for_case();
    void begin();
    void show_progress(const JobProgress& progress);
    void show_events();
    void set_playing(bool playing);
    void tick();
    void go_to(double at_s);
    void jump(int direction);  // to the next event, or to the one before
    void add_note();
    void remove_note();
    bool keep(std::vector<PlayNote> notes);
    void show_other();
    double end_s() const;  // of the longer one
    void leave();
    void forget();

    Ways ways_;
    std::filesystem::path file_;
    QString name_;                         // of the recording, for the user
    std::array<QString, 2> side_by_side_;  // of both, while two are shown
    bool same_lesson_ = false;             // as the one beside it: it has the same marks
    std::shared_ptr<const Recording> recording_;
    std::optional<Lesson> lesson_;
    std::unique_ptr<const PlayMeter> places_;  // of its marks; null: it has none on these vessels
    bool waits_ = false;                       // for its patient
    std::shared_ptr<const PatientCase> patient_;  // on whom it was begun
    std::unique_ptr<BackgroundJob> job_;
    std::shared_ptr<ReviewTape> tape_;
    std::shared_ptr<ReviewScreen> screen_;
    std::filesystem::path other_file_;  // beside it
    std::unique_ptr<BackgroundJob> other_job_;
    std::shared_ptr<ReviewTape> other_tape_;
    std::shared_ptr<const Frame> other_frame_;  // that is shown
    std::vector<PlayNote> notes_;
    double at_s_ = 0.0;
    QTimer clock_;
    QElapsedTimer since_tick_;

    QLabel* title_ = nullptr;
    TimeLine* line_ = nullptr;
    QLabel* time_ = nullptr;
    QToolButton* play_ = nullptr;
    QComboBox* speed_ = nullptr;
    ReviewList* events_ = nullptr;
    QLineEdit* note_ = nullptr;
    QPushButton* remove_ = nullptr;
    QPushButton* compare_ = nullptr;
};

}  // namespace hepatica
