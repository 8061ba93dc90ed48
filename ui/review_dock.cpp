// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review_dock.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "ui/core_words.h"
#include "ui/elided_label.h"
#include "ui/lesson_marks.h"
#include "ui/review_list.h"
#include "ui/review_play.h"
#include "ui/time_line.h"
#include "ui/words.h"

namespace hepatica {

namespace {
constexpr int tick_ms = 16;
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
    connect(film, &QPushButton::clicked, this, [this] { save(ways_.save_film); });
    row->addWidget(film);
    auto* pictures = new QPushButton(Words::tr("Save its pictures…"));
    pictures->setObjectName("reviewPictures");
    pictures->setToolTip(Words::tr("Each picture of the film as a PNG file, in a folder"));
    connect(pictures, &QPushButton::clicked, this, [this] { save(ways_.save_pictures); });
    row->addWidget(pictures);
    auto* leave_button = new QPushButton(Words::tr("Leave &the review"));
    leave_button->setObjectName("reviewLeave");
    connect(leave_button, &QPushButton::clicked, this, [this] { leave(); });
    row->addWidget(leave_button);
    return box;
}

void ReviewDock::save(const SaveMoments& moments) {
    if (!complete()) return ways_.say(Words::tr("The recording is still being read."));
    set_playing(false);
    const double before_s = at_s_;
    moments(end_s(), [this](double at_s) { go_to(at_s); });
    go_to(before_s);
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
    connect(line_, &QSlider::valueChanged, this, [this] {
        const bool beyond = reviewing() && !all_computed() && line_->at_s() > end_s();
        go_to(line_->at_s());
        if (beyond)
            ways_.say(
                Words::tr("That part is not read yet: what was played is computed again, "
                          "which takes about as long"));
    });
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
    if (!reviewing()) return;
    QString name = name_;
    if (comparing())
        name = Words::tr("%1, and beside it %2").arg(side_by_side_[0], side_by_side_[1]);
    title_->setText(all_computed() ? name : gone_through(name, progress.fraction));
    const QSignalBlocker quiet(line_);
    line_->set_end(length_s());
    line_->set_read(read_s());
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
    if (playing && all_computed() && at_s_ >= end_s()) go_to(0.0);
    since_tick_.start();
    playing ? clock_.start() : clock_.stop();
    play_->setIcon(style()->standardIcon(playing ? QStyle::SP_MediaPause : QStyle::SP_MediaPlay));
    ways_.stopped_or_went_on();
}

void ReviewDock::tick() {
    const double wall_s = 1e-3 * static_cast<double>(since_tick_.restart());
    const double speed = speeds[static_cast<std::size_t>(speed_->currentIndex())];
    go_to(at_s_ + speed * wall_s);
    if (all_computed() && at_s_ >= end_s()) set_playing(false);
}

void ReviewDock::go_to(double at_s) {
    if (!reviewing()) return;
    at_s_ = std::clamp(at_s, 0.0, end_s());
    const QSignalBlocker quiet(line_);
    line_->set_at(at_s_);
    time_->setText(Words::tr("%1 of %2").arg(clock_text(at_s_), clock_text(length_s())));
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
    forget_shown();
    ways_.use(nullptr);
}

void ReviewDock::forget() {
    next_.reset();
    forget_shown();
}

void ReviewDock::forget_shown() {
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
    events_->fill({}, {}, {});
    line_->set_ticks({});
    note_->clear();  // half typed about a moment of this recording
    hide();
}

}  // namespace hepatica
