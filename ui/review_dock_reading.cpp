// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the review that reads a recording, finds its patient, and shows it as soon as its
// first frame is there; what was shown before stays until then.
#include <QMainWindow>
#include <QTimer>
#include <utility>

#include "core/base/error.h"
#include "core/lesson/attempts.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/review.h"
#include "core/lesson/score.h"
#include "core/opening/recorded_case.h"
#include "core/session/recording_file.h"
#include "ui/core_words.h"
#include "ui/lesson_marks.h"
#include "ui/paths.h"
#include "ui/recording_dialog.h"
#include "ui/review_dock.h"
#include "ui/review_play.h"
#include "ui/words.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

constexpr int height_at_first = 200;

}  // namespace

// A recording with what it needs; `request` opens its patient if he is not the shown one.
struct ReviewDock::Found {
    std::shared_ptr<const Recording> recording;
    std::optional<Lesson> lesson;
    std::vector<PlayNote> notes;
    std::optional<OpenRequest> request;
};

struct ReviewDock::Next {
    fs::path file;
    QString name;
    std::shared_ptr<const Recording> recording;  // null until it is read
    std::optional<Lesson> lesson;
    std::vector<PlayNote> notes;
    bool waits = false;                          // for its patient, who is being opened
    bool asks = false;                           // for his case: whoever opens it begins the review
    std::shared_ptr<const PatientCase> patient;  // as the members of the dock from here on
    std::unique_ptr<const MarkedLesson> marked;
    std::shared_ptr<ReviewTape> tape;
    std::unique_ptr<BackgroundJob> job;
};

bool ReviewDock::may_begin(const fs::path& recording) const {
    const char* why = ways_.lesson_runs()
                          ? Words::id("a lesson is being played, which this would end")
                      : ways_.vessels_change()
                          ? Words::id("the vessels are being corrected, which would end the review")
                          : nullptr;
    if (why == nullptr) return true;
    ways_.failed({why, recording.string(),
                  ways_.lesson_runs() ? Words::id("Leave the lesson first")
                                      : Words::id("Wait until the correction is made")});
    return false;
}

void ReviewDock::open(const fs::path& recording, const std::string& lesson) {
    if (!may_begin(recording)) return;
    next_ = std::make_shared<Next>();
    next_->file = recording;
    next_->name = title_of(facts_of(recording));
    BackgroundJob::Callbacks callbacks;
    callbacks.failed = [this](const Failure& failure) { ways_.failed(failure); };
    const QString reading = Words::tr("Reading the recording…");
    callbacks.ended = [this, reading, own = std::weak_ptr(next_)] {
        ways_.unsay(reading);
        const std::shared_ptr<Next> read = own.lock();
        if (read == nullptr) return;  // given up meanwhile
        read->job.reset();
        if (read->recording == nullptr) next_.reset();  // what was shown stays
    };
    ways_.say(reading);
    next_->job = std::make_unique<BackgroundJob>(
        [this, file = recording, lesson,
         shown = ways_.patient()](Job& job) -> std::function<void()> {
            Found found;
            found.recording = std::make_shared<const Recording>(read_recording(file));
            found.lesson = lesson.empty() ? built_in_lesson_of(*found.recording)
                                          : std::optional(find_lesson(lesson));
            found.notes = read_notes(file);
            const std::uint64_t wanted = found.recording->patient_hash;
            if (shown == nullptr || hash_of(*shown) != wanted) {
                found.request.emplace();
                const CaseSearch search = case_beside(file, wanted, job);
                if (search.found)
                    found.request->reconstruct.ct = *search.found;
                else if (found.lesson && found.lesson->patient == "built-in")
                    found.request->built_in = true;
            }
            return [this, found = std::move(found)] { take(found); };
        },
        std::move(callbacks));
}

void ReviewDock::take(Found found) {
    if (!may_begin(next_->file)) return next_.reset();
    next_->recording = std::move(found.recording);
    next_->lesson = std::move(found.lesson);
    next_->notes = std::move(found.notes);
    for (const std::string& warning : next_->recording->warnings) ways_.say(translated(warning));
    // The job that called this still exists; the next one begins after it.
    if (!found.request) return QTimer::singleShot(0, this, [this] { begin(); });
    OpenRequest& request = *found.request;
    if (request.reconstruct.ct.empty()) {
        const fs::path known = ways_.known_case(next_->recording->patient_hash);
        if (!known.empty() && is_case(known))
            request.reconstruct.ct = known;
        else if (!request.built_in && (!known.empty() || ways_.patient() != nullptr))
            return ask_for_case();
        else
            request.built_in = true;  // perhaps it was played on him
    }
    next_->waits = true;
    ways_.open(request);
}

void ReviewDock::open_case(const fs::path& place) {
    OpenRequest request;
    request.reconstruct.ct = place;
    next_->waits = true;
    ways_.open(request);
}

void ReviewDock::ask_for_case() {
    const fs::path known = ways_.known_case(next_->recording->patient_hash);
    Failure failure{Words::id("was played on another patient, of whom no case lies beside it"),
                    next_->file.string(), Words::id("Choose the case that was played on")};
    if (!known.empty())
        failure.problem = Words::tr(
                              "was played on %1, which is not there any more or holds other "
                              "vessels by now")
                              .arg(to_text(known))
                              .toStdString();
    if (ways_.work_is_unsaved())
        failure.remedy = Words::id("Open the unsaved work first (File > Open unsaved work)");
    next_->asks = true;
    ways_.choose_case(failure, [this, asked = std::weak_ptr(next_)](const fs::path& place) {
        if (!asked.expired() && asked.lock() == next_) open_case(place);
    });
}

void ReviewDock::patient_shown() {
    // A review of another patient ends, even if nothing of it is shown yet.
    if (patient_ != nullptr && ways_.patient() != patient_) forget_shown();
    if (next_ == nullptr) return;
    const bool comes_by_hand = next_->asks && ways_.patient() &&
                               hash_of(*ways_.patient()) == next_->recording->patient_hash;
    if (std::exchange(next_->waits, false) || comes_by_hand)
        return QTimer::singleShot(0, this, [this] { begin(); });
    if (next_->patient != nullptr && ways_.patient() != next_->patient) next_.reset();
}

void ReviewDock::patient_not_shown() {
    if (next_ && next_->waits) next_.reset();
}

bool ReviewDock::reads_next() const {
    return next_ != nullptr && (next_->waits || next_->job != nullptr);
}

void ReviewDock::begin() {
    const auto patient = ways_.patient();
    if (next_ == nullptr || next_->recording == nullptr || patient == nullptr) return;
    const std::shared_ptr<const Recording> recording = next_->recording;
    if (!may_begin(next_->file)) return next_.reset();  // something has begun meanwhile
    if (hash_of(*patient) != recording->patient_hash) return ask_for_case();
    const std::optional<Lesson>& lesson = next_->lesson;
    next_->asks = false;
    next_->patient = patient;
    if (lesson && is_same_scene(recording->scene, lesson->scene))
        next_->marked = std::make_unique<const MarkedLesson>(*lesson, patient);
    const auto tape = next_->tape = std::make_shared<ReviewTape>();
    BackgroundJob::Callbacks callbacks;
    callbacks.progress = [this, tape](const JobProgress& now) {
        if (shows(tape)) show_progress(now);
    };
    callbacks.failed = [this](const Failure& failure) { ways_.failed(failure); };
    callbacks.ended = [this, tape] {
        if (!shows(tape)) return next_.reset();  // not one frame could be computed
        job_.reset();
        show_progress({});
    };
    next_->job = std::make_unique<BackgroundJob>(
        [recording, lesson = with_course_pass(lesson, next_->file), patient, tape,
         interrupted = interrupted_beside(next_->file),
         back_end = ways_.back_end](Job& job) -> std::function<void()> {
            review(*recording, lesson, patient, *tape, job, back_end(recording->back_end),
                   interrupted);
            return [] {};
        },
        std::move(callbacks));
}

bool ReviewDock::shows(const std::shared_ptr<ReviewTape>& tape) {
    if (next_ && next_->tape == tape && tape->at(0.0) != nullptr) show_next();
    return tape_ == tape;
}

// In the place of what was shown until now, without the free play in between.
void ReviewDock::show_next() {
    const std::shared_ptr<Next> next = std::exchange(next_, nullptr);
    // Its job called this, and ends later.
    if (!may_begin(next->file)) return QTimer::singleShot(0, this, [next] {});
    forget_shown();
    file_ = next->file;
    name_ = next->name;
    recording_ = next->recording;
    played_s_ = played_s(*recording_);
    lesson_ = next->lesson;
    notes_ = std::move(next->notes);
    marked_ = std::move(next->marked);
    patient_ = next->patient;
    tape_ = next->tape;
    job_ = std::move(next->job);
    screen_ = std::make_shared<ReviewScreen>();
    screen_->tape = tape_;
    screen_->wanted = tape_->at(0.0);
    screen_->hold = [this] { set_playing(!playing()); };
    screen_->touched = [this] {
        ways_.say(Words::tr("This is a recording. Leave the review to play yourself."));
    };
    ways_.use(std::make_unique<ReviewPlay>(screen_));
    screen_->gone = [this] { forget_shown(); };
    at_s_ = 0.0;
    show();
    raise();
    // The view keeps its room; the user can drag the border for a longer list.
    if (auto* window = qobject_cast<QMainWindow*>(parentWidget()))
        window->resizeDocks({this}, {height_at_first}, Qt::Vertical);
    set_playing(true);
}

}  // namespace hepatica
