// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review_dock.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/lesson/attempts.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/review.h"
#include "core/lesson/score.h"
#include "core/opening/recorded_case.h"
#include "core/session/recording_file.h"
#include "ui/core_words.h"
#include "ui/elided_label.h"
#include "ui/lesson_marks.h"
#include "ui/paths.h"
#include "ui/recording_dialog.h"
#include "ui/review_list.h"
#include "ui/review_play.h"
#include "ui/time_line.h"
#include "ui/words.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {
constexpr int tick_ms = 16;
constexpr int height_at_first = 200;
constexpr std::array<double, 6> speeds{0.1, 0.25, 0.5, 1.0, 2.0, 4.0};
constexpr int real_time = 3;  // index of the speed 1

QToolButton* add_button(QHBoxLayout& row, const char* name, QStyle::StandardPixmap icon,
                        const QString& tip) {
    auto* button = new QToolButton;
    button->setObjectName(name);
    button->setIcon(button->style()->standardIcon(icon));
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    button->setFocusPolicy(Qt::StrongFocus);
    row.addWidget(button);
    return button;
}

}  // namespace

// A recording with what it needs; `request` opens its patient if he is not the shown one.
struct ReviewDock::Found {
    std::shared_ptr<const Recording> recording;
    std::optional<Lesson> lesson;
    std::vector<PlayNote> notes;
    std::optional<OpenRequest> request;
};

ReviewDock::ReviewDock(Ways ways, QWidget* parent)
    : QDockWidget(Words::tr("Review"), parent), ways_(std::move(ways)) {
    setObjectName("Review");
    setFeatures(QDockWidget::DockWidgetMovable);
    build();
    clock_.setInterval(tick_ms);
    clock_.setTimerType(Qt::PreciseTimer);
    connect(&clock_, &QTimer::timeout, this, [this] { tick(); });
    hide();
}

ReviewDock::~ReviewDock() {
    forget();
}

void ReviewDock::build() {
    auto* content = new QWidget(this);
    auto* column = new QVBoxLayout(content);
    column->setSpacing(4);
    column->addWidget(build_heading());
    column->addWidget(build_controls());
    events_ = new ReviewList;
    events_->setObjectName("reviewEvents");
    connect(events_, &QListWidget::currentRowChanged, this, [this](int row) {
        remove_->setEnabled(events_->note(row).has_value());
        if (row >= 0) go_to(events_->at_s(row));
    });
    // Also on the row that is current already.
    const auto again = [this](QListWidgetItem* item) { go_to(events_->at_s(events_->row(item))); };
    connect(events_, &QListWidget::itemClicked, this, again);
    connect(events_, &QListWidget::itemActivated, this, again);
    column->addWidget(events_, 1);
    column->addWidget(build_notes());
    setWidget(content);
}

QWidget* ReviewDock::build_heading() {
    auto* box = new QWidget;
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    title_ = new ElidedLabel(Qt::ElideRight, box);
    title_->setObjectName("reviewTitle");
    row->addWidget(title_, 1);
    compare_ = new QPushButton(Words::tr("&Compare with…"));
    compare_->setObjectName("reviewCompare");
    compare_->setToolTip(Words::tr("Show another recording of this patient beside it"));
    connect(compare_, &QPushButton::clicked, this, [this] {
        if (comparing()) return compare({});
        if (const auto other = ways_.ask_for_other()) compare(*other);
    });
    row->addWidget(compare_);
    auto* film = new QPushButton(Words::tr("&Save a film…"));
    film->setObjectName("reviewFilm");
    film->setToolTip(
        Words::tr("As one MP4 file where ffmpeg is installed, else as a folder of pictures"));
    connect(film, &QPushButton::clicked, this, [this] {
        if (!complete()) return ways_.say(Words::tr("The recording is still being read."));
        set_playing(false);
        ways_.save_film(end_s(), [this](double at_s) { go_to(at_s); });
    });
    row->addWidget(film);
    auto* leave_button = new QPushButton(Words::tr("Leave &the review"));
    leave_button->setObjectName("reviewLeave");
    connect(leave_button, &QPushButton::clicked, this, [this] { leave(); });
    row->addWidget(leave_button);
    return box;
}

QWidget* ReviewDock::build_controls() {
    auto* box = new QWidget;
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    auto* back = add_button(*row, "reviewBack", QStyle::SP_MediaSkipBackward,
                            Words::tr("To what happened before"));
    play_ = add_button(*row, "reviewPlay", QStyle::SP_MediaPlay, Words::tr("Play or stop"));
    auto* on = add_button(*row, "reviewOn", QStyle::SP_MediaSkipForward,
                          Words::tr("To what happens next"));
    connect(back, &QToolButton::clicked, this, [this] { jump(-1); });
    connect(play_, &QToolButton::clicked, this, [this] { set_playing(!playing()); });
    connect(on, &QToolButton::clicked, this, [this] { jump(+1); });
    speed_ = new QComboBox;
    speed_->setObjectName("reviewSpeed");
    speed_->setAccessibleName(Words::tr("Speed"));
    speed_->setToolTip(Words::tr("How fast it is played; 1 is as it was"));
    for (const double speed : speeds) speed_->addItem(QString("%L1 ×").arg(speed));
    speed_->setCurrentIndex(real_time);
    row->addWidget(speed_);
    line_ = new TimeLine;
    line_->setObjectName("reviewLine");
    connect(line_, &QSlider::valueChanged, this, [this] { go_to(line_->at_s()); });
    row->addWidget(line_, 1);
    time_ = new QLabel;
    time_->setObjectName("reviewTime");
    row->addWidget(time_);
    return box;
}

QWidget* ReviewDock::build_notes() {
    auto* box = new QWidget;
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    note_ = new QLineEdit;
    note_->setObjectName("reviewNote");
    note_->setPlaceholderText(
        Words::tr("A note at this moment; Enter keeps it beside the recording"));
    note_->setAccessibleName(Words::tr("A note at this moment"));
    note_->setMaxLength(2000);
    connect(note_, &QLineEdit::returnPressed, this, [this] { add_note(); });
    row->addWidget(note_, 1);
    remove_ = new QPushButton(Words::tr("Remove the note"));
    remove_->setObjectName("reviewRemoveNote");
    remove_->setEnabled(false);
    connect(remove_, &QPushButton::clicked, this, [this] { remove_note(); });
    row->addWidget(remove_);
    return box;
}

void ReviewDock::open(const fs::path& recording, const std::string& lesson) {
    if (ways_.lesson_runs())
        return ways_.failed({Words::id("a lesson is being played, which this would end"),
                             recording.string(), Words::id("Leave the lesson first")});
    if (reviewing()) leave();
    forget();
    file_ = recording;
    name_ = title_of(facts_of(file_));
    BackgroundJob::Callbacks callbacks;
    callbacks.failed = [this](const Failure& failure) { ways_.failed(failure); };
    const QString reading = Words::tr("Reading the recording…");
    callbacks.ended = [this, reading] {
        ways_.unsay(reading);
        job_.reset();
    };
    ways_.say(reading);
    job_ = std::make_unique<BackgroundJob>(
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
    recording_ = std::move(found.recording);
    lesson_ = std::move(found.lesson);
    notes_ = std::move(found.notes);
    for (const std::string& warning : recording_->warnings) ways_.say(translated(warning));
    // The job that called this still exists; the next one begins after it.
    if (!found.request) return QTimer::singleShot(0, this, [this] { begin(); });
    OpenRequest& request = *found.request;
    if (request.reconstruct.ct.empty()) {
        const fs::path known = ways_.known_case(recording_->patient_hash);
        if (!known.empty() && is_case(known))
            request.reconstruct.ct = known;
        else if (!request.built_in && (!known.empty() || ways_.patient() != nullptr))
            return ask_for_case();
        else
            request.built_in = true;  // perhaps it was played on him
    }
    waits_ = true;
    ways_.open(request);
}

void ReviewDock::open_case(const fs::path& place) {
    OpenRequest request;
    request.reconstruct.ct = place;
    waits_ = true;
    ways_.open(request);
}

void ReviewDock::ask_for_case() {
    const fs::path known = ways_.known_case(recording_->patient_hash);
    Failure failure{Words::id("was played on another patient, of whom no case lies beside it"),
                    file_.string(), Words::id("Choose the case that was played on")};
    if (!known.empty())
        failure.problem = Words::tr(
                              "was played on %1, which is not there any more or holds other "
                              "vessels by now")
                              .arg(to_text(known))
                              .toStdString();
    if (ways_.work_is_unsaved())
        failure.remedy = Words::id("Open the unsaved work first (File > Open unsaved work)");
    asks_ = true;
    ways_.choose_case(failure, [this, asked = std::weak_ptr(recording_)](const fs::path& place) {
        if (!asked.expired() && asked.lock() == recording_) open_case(place);
    });
}

void ReviewDock::patient_shown() {
    const bool comes_by_hand =
        asks_ && ways_.patient() && hash_of(*ways_.patient()) == recording_->patient_hash;
    if (std::exchange(waits_, false) || comes_by_hand)
        return QTimer::singleShot(0, this, [this] { begin(); });
    // A review of another patient ends, even if nothing of it is shown yet.
    if (patient_ != nullptr && ways_.patient() != patient_) forget();
}

void ReviewDock::begin() {
    const auto patient = ways_.patient();
    if (recording_ == nullptr || patient == nullptr) return;
    if (hash_of(*patient) != recording_->patient_hash) return ask_for_case();
    asks_ = false;
    patient_ = patient;
    marked_.reset();
    if (lesson_ && is_same_scene(recording_->scene, lesson_->scene))
        marked_ = std::make_unique<const MarkedLesson>(*lesson_, patient);
    tape_ = std::make_shared<ReviewTape>();
    BackgroundJob::Callbacks callbacks;
    callbacks.progress = [this](const JobProgress& now) { show_progress(now); };
    callbacks.failed = [this](const Failure& failure) { ways_.failed(failure); };
    callbacks.ended = [this] {
        job_.reset();
        show_progress({});
    };
    job_ = std::make_unique<BackgroundJob>(
        [recording = recording_, lesson = with_course_pass(lesson_, file_), patient, tape = tape_,
         back_end = ways_.back_end](Job& job) -> std::function<void()> {
            review(*recording, lesson, patient, *tape, job, back_end(recording->back_end));
            return [] {};
        },
        std::move(callbacks));
}

std::vector<MarkView> ReviewDock::marks_in(const Frame& frame) const {
    return reviewing() ? marks_in(frame, *tape_, marked_.get()) : std::vector<MarkView>();
}

std::vector<MarkView> ReviewDock::marks_in(const Frame& frame, const ReviewTape& tape,
                                           const MarkedLesson* marked) const {
    if (marked == nullptr) return {};
    const std::vector<PlayEvent> events = tape.events();
    const auto steps = std::ranges::count_if(events, [this](const PlayEvent& event) {
        return event.kind == PlayEventKind::lesson && event.at_s <= at_s_;
    });
    return marked->marks_in(frame, static_cast<std::size_t>(steps));
}

QString gone_through(const QString& name, double fraction) {
    return Words::tr("%1: %2 % of the recording read")
        .arg(name, QString::number(static_cast<int>(100.0 * fraction)));
}

void ReviewDock::show_progress(const JobProgress& progress) {
    if (tape_ == nullptr) return;
    const auto first = tape_->at(0.0);
    if (first == nullptr) return;
    if (!reviewing()) {
        screen_ = std::make_shared<ReviewScreen>();
        screen_->tape = tape_;
        screen_->wanted = first;
        screen_->hold = [this] { set_playing(!playing()); };
        screen_->touched = [this] {
            ways_.say(Words::tr("This is a recording. Leave the review to play yourself."));
        };
        ways_.use(std::make_unique<ReviewPlay>(screen_));
        screen_->gone = [this] { forget(); };
        at_s_ = 0.0;
        show();
        raise();
        // The view keeps its room; the user can drag the border for a longer list.
        if (auto* window = qobject_cast<QMainWindow*>(parentWidget()))
            window->resizeDocks({this}, {height_at_first}, Qt::Vertical);
        set_playing(true);
    }
    QString name = name_;
    if (comparing())
        name = Words::tr("%1, and beside it %2").arg(side_by_side_[0], side_by_side_[1]);
    title_->setText(complete() ? name : gone_through(name, progress.fraction));
    const QSignalBlocker quiet(line_);
    line_->set_end(end_s());
    show_events();
    go_to(at_s_);
}

void ReviewDock::show_events() {
    events_->fill(tape_->events(), comparing() ? other_tape_->events() : std::vector<PlayEvent>(),
                  notes_);
    remove_->setEnabled(events_->note(events_->currentRow()).has_value());
    line_->set_ticks(events_->ticks());
}

void ReviewDock::set_playing(bool playing) {
    if (!reviewing()) return;
    if (playing && complete() && at_s_ >= end_s()) go_to(0.0);
    since_tick_.start();
    playing ? clock_.start() : clock_.stop();
    play_->setIcon(style()->standardIcon(playing ? QStyle::SP_MediaPause : QStyle::SP_MediaPlay));
    ways_.stopped_or_went_on();
}

void ReviewDock::tick() {
    const double wall_s = 1e-3 * static_cast<double>(since_tick_.restart());
    const double speed = speeds[static_cast<std::size_t>(speed_->currentIndex())];
    go_to(at_s_ + speed * wall_s);
    if (complete() && at_s_ >= end_s()) set_playing(false);
}

void ReviewDock::go_to(double at_s) {
    if (!reviewing()) return;
    at_s_ = std::clamp(at_s, 0.0, end_s());
    const QSignalBlocker quiet(line_);
    line_->set_at(at_s_);
    time_->setText(Words::tr("%1 of %2").arg(clock_text(at_s_), clock_text(end_s())));
    screen_->show_at(at_s_);
    show_other();
}

void ReviewDock::jump(int direction) {
    const int row = events_->next_row(at_s_, direction);
    if (row < 0) return;
    events_->setCurrentRow(row);
    go_to(events_->at_s(row));  // also if the row was current already
}

void ReviewDock::add_note() {
    const std::string text = note_->text().trimmed().toStdString();
    if (!reviewing() || text.empty()) return;
    std::vector<PlayNote> notes = notes_;
    notes.push_back({at_s_, text});
    std::ranges::stable_sort(notes, {}, &PlayNote::at_s);
    if (keep(std::move(notes))) note_->clear();
}

void ReviewDock::remove_note() {
    const auto index = events_->note(events_->currentRow());
    if (!reviewing() || !index) return;
    std::vector<PlayNote> notes = notes_;
    notes.erase(notes.begin() + static_cast<std::ptrdiff_t>(*index));
    const QString text = QString::fromStdString(notes_[*index].text);
    if (!keep(std::move(notes))) return;
    note_->setText(note_->text().isEmpty() ? text : note_->text() + " " + text);
    ways_.say(Words::tr("Removed; its text stands in the line for notes: Enter keeps it again"));
}

// Written at once; on failure the former notes stay.
bool ReviewDock::keep(std::vector<PlayNote> notes) {
    try {
        write_notes(file_, notes);
    } catch (...) {
        ways_.failed(failure_of(std::current_exception()));
        return false;
    }
    notes_ = std::move(notes);
    show_events();
    return true;
}

void ReviewDock::leave() {
    if (!reviewing()) return hide();
    forget();
    ways_.use(nullptr);
}

void ReviewDock::forget() {
    clock_.stop();
    job_.reset();
    other_job_.reset();
    other_frame_.reset();
    if (std::exchange(other_tape_, nullptr)) ways_.beside(nullptr, {}, {}, {});
    compare_->setText(Words::tr("&Compare with…"));
    if (screen_) screen_->gone = nullptr;
    screen_.reset();
    tape_.reset();
    patient_.reset();
    recording_.reset();
    marked_.reset();
    lesson_.reset();
    notes_.clear();
    waits_ = asks_ = false;
    events_->fill({}, {}, {});
    line_->set_ticks({});
    note_->clear();  // half typed about a moment of this recording
    hide();
}

}  // namespace hepatica
