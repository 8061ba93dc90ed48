// SPDX-License-Identifier: GPL-3.0-or-later
// Dock that reviews a recording: time line with events, speed, jumps, and notes, which are stored
// beside the recording. The window provides the patient and shows the tape as a simulation.
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

class MarkedLesson;
class ReviewList;
class TimeLine;
struct ReviewScreen;

// Title of a recording of this name while its frames are computed; `fraction` of them are there.
QString gone_through(const QString& name, double fraction);

// UI thread only.
class ReviewDock : public QDockWidget {
  public:
    using SaveMoments =
        std::function<void(double end_s, const std::function<void(double at_s)>& go_to)>;
    struct Ways {
        // The shown patient; null: none.
        std::function<std::shared_ptr<const PatientCase>()> patient;
        std::function<void(const OpenRequest&)> open;  // asynchronous; patient_shown() follows
        // The back end that a recording names. Any thread; throws InputError if it is unavailable.
        std::function<DeformBackEnd(const std::string& name)> back_end = [](const std::string&) {
            return cpu_back_end();
        };
        // Replaces the running simulation; null: by free play.
        std::function<void(std::unique_ptr<Simulation>)> use;
        // Asks for a recording to compare with; nullopt: cancelled.
        std::function<std::optional<std::filesystem::path>()> ask_for_other;
        // Shows a frame beside the first view, with its marks and both titles; null: removes it.
        std::function<void(const std::shared_ptr<const Frame>& frame, std::vector<MarkView> marks,
                           const QString& first, const QString& other)>
            beside;
        // Makes a film of the review, or a picture of each of its moments; `go_to` shows a moment.
        SaveMoments save_film, save_pictures;
        // The case of a patient with this hash, where these settings know it; else empty.
        std::function<std::filesystem::path(std::uint64_t hash)> known_case = [](std::uint64_t) {
            return std::filesystem::path();
        };
        // An earlier run left unsaved work, which may hold the vessels of a recording.
        std::function<bool()> work_is_unsaved = [] { return false; };
        // Says what failed, and lets the person choose the case in question.
        std::function<void(const Failure&, std::function<void(const std::filesystem::path&)>)>
            choose_case =
                [](const Failure&, const std::function<void(const std::filesystem::path&)>&) {};
        std::function<void()> stopped_or_went_on = [] {};  // its clock did
        std::function<bool()> lesson_runs;  // a lesson runs, which a review would end
        // Other vessels of the shown patient are being made, which would end a review.
        std::function<bool()> vessels_change = [] { return false; };
        std::function<void(const Failure&)> failed;
        std::function<void(const QString&)> say;     // a passing message
        std::function<void(const QString&)> unsay =  // takes it back if it still stands
            [](const QString&) {};
    };

    ReviewDock(Ways ways, QWidget* parent);
    ~ReviewDock() override;

    // Reads the recording and finds its patient: the shown one, a case beside the recording, or the
    // built-in one if nobody is shown or its lesson is played on him. Shows the recording from the
    // beginning while the rest is still computed; what was reviewed before stays until then.
    // `lesson`: file or id; empty: the built-in lesson with that scene, if any.
    void open(const std::filesystem::path& recording, const std::string& lesson = {});
    // Stops the review and all reading; the simulation stays.
    void end() { forget(); }
    // The patient being opened will not come: a recording that waits for him is dropped.
    void patient_not_shown();
    // Another patient is shown: a recording that waited for him, or asked for his case, begins; one
    // of another patient ends.
    void patient_shown();
    // Shows another recording of the same patient beside it; an empty path ends that.
    void compare(const std::filesystem::path& other);
    bool comparing() const { return other_tape_ != nullptr; }
    // A recording is shown.
    bool reviewing() const { return screen_ != nullptr; }
    bool of_lesson() const { return reviewing() && lesson_.has_value(); }
    // All frames of the recording, and of the one beside it, are computed, and no other one is to
    // be shown in its place.
    bool complete() const { return all_computed() && !reads_next(); }

    // A recording is being read or computed, or waits for its patient.
    bool busy() const { return job_ != nullptr || reads_next(); }
    // The lesson's marks in a frame at the shown moment; empty without a lesson.
    std::vector<MarkView> marks_in(const Frame& frame) const;
    double at_s() const { return at_s_; }
    bool playing() const { return clock_.isActive(); }

    // The recording reviewed now or last.
    const std::filesystem::path& file() const { return file_; }

  private:
    // `marked`: the lesson of the tape; null: none on these vessels.
    std::vector<MarkView> marks_in(const Frame& frame, const ReviewTape& tape,
                                   const MarkedLesson* marked) const;
    struct Found;             // a recording that was read, with what it needs
    struct Next;              // the one that is to be shown
    bool reads_next() const;  // or waits for its patient
    bool all_computed() const { return reviewing() && job_ == nullptr && other_job_ == nullptr; }
    void build();
    QWidget* build_heading();
    void save(const SaveMoments& moments);  // and goes back to where it was
    QWidget* build_controls();
    QWidget* build_notes();
    // Says why no review begins now, if none may.
    bool may_begin(const std::filesystem::path& recording) const;
    void take(Found found);
    void open_case(const std::filesystem::path& place);
    void ask_for_case();
    void begin();
    // Whether the recording of this tape is shown, which it is from its first frame on.
    bool shows(const std::shared_ptr<ReviewTape>& tape);
    void show_next();
    void show_progress(const JobProgress& progress);
    void show_events();
    void set_playing(bool playing);
    void tick();
    void go_to(double at_s);
    void jump(int direction);  // to the next event (+1) or the previous one (-1)
    void add_note();
    void remove_note();
    bool keep(std::vector<PlayNote> notes);
    void show_other();
    double end_s() const;     // of the longer recording, as far as it is computed
    double read_s() const;    // the same of the one of which less is computed
    double length_s() const;  // the same once it is, which its commands tell before
    void leave();
    void forget();
    void forget_shown();

    Ways ways_;
    std::filesystem::path file_;
    QString name_;                         // title of the recording
    std::array<QString, 2> side_by_side_;  // titles of both, while two are shown
    std::shared_ptr<const Recording> recording_;
    std::optional<Lesson> lesson_;
    std::unique_ptr<const MarkedLesson> marked_;  // null: no lesson on these vessels
    std::shared_ptr<const PatientCase> patient_;  // the patient it was begun on
    std::unique_ptr<BackgroundJob> job_;
    std::shared_ptr<ReviewTape> tape_;
    std::shared_ptr<ReviewScreen> screen_;
    std::shared_ptr<Next> next_;  // null: none
    std::unique_ptr<BackgroundJob> other_job_;
    std::shared_ptr<ReviewTape> other_tape_;
    // Of the lesson of that recording: made on another thread before the first of its frames is on
    // the tape, and to be looked at only once there is one. Not null while there is that tape.
    std::shared_ptr<std::unique_ptr<const MarkedLesson>> other_marked_;
    std::shared_ptr<const Frame> other_frame_;  // the one that is shown
    std::vector<PlayNote> notes_;
    double played_s_ = 0.0;  // as the commands of the recording tell
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
