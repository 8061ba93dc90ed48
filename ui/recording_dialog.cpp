// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/recording_dialog.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/text_file.h"
#include "core/lesson/attempts.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/review.h"
#include "core/session/recording_file.h"
#include "ui/core_words.h"
#include "ui/on_screen.h"
#include "ui/paths.h"
#include "ui/plain_text.h"
#include "ui/recording_guard.h"
#include "ui/time_line.h"
#include "ui/time_of_play.h"
#include "ui/words.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

constexpr int length_column = 2, file_column = 5;

// The name of a lesson that is tried, which lies beside the recording until another one is.
QString tried_lesson(const fs::path& recording) {
    try {
        return translated(read_lesson(recording.parent_path() / "lesson.json").name);
    } catch (const InputError&) {
        return Words::tr("Lesson");
    }
}

std::optional<std::uint64_t> patient_of(const fs::path& recording) {
    try {
        return read_recording(recording, RecordingPart::header).patient_hash;
    } catch (const InputError&) {
        return std::nullopt;  // it is told when the recording is opened
    }
}

// The lesson in the file's name: a built-in lesson's id, or the name of its file.
QString lesson_in_name(const fs::path& recording) {
    static const QRegularExpression time("-\\d{8}-\\d{6}-\\d{3}$");
    QString name = to_text(recording.stem()).remove(time);
    if (name == "play") return Words::tr("Free play");
    if (name == "lesson") return tried_lesson(recording);
    for (const BuiltInLesson& lesson : built_in_lessons())
        if (name == lesson.id) return translated(find_lesson(lesson.id).name);
    return name;
}

}  // namespace

RecordingFacts facts_of(const fs::path& recording) {
    RecordingFacts facts{
        recording, lesson_in_name(recording), words_on_time_of_play(recording), {}};
    const fs::path result = result_file_of(recording);
    std::error_code ignored;
    if (!fs::exists(result, ignored)) {
        const bool free = facts.lesson == Words::tr("Free play");
        facts.result = is_being_recorded(recording) ? Words::tr("is being recorded")
                       : free                       ? QString()
                                                    : Words::tr("interrupted");
        return facts;
    }
    try {
        const Attempt attempt =
            attempt_from(read_text_file(result, ""), recording, result.string());
        facts.lesson = translated(attempt.lesson);
        facts.trainee = QString::fromStdString(attempt.name);
        facts.result = was_interrupted(attempt) ? Words::tr("interrupted")
                       : attempt.passed         ? Words::tr("✓ passed")
                                                : Words::tr("✗ not passed");
    } catch (const InputError&) {
        // The recording can be opened without its result.
    }
    return facts;
}

QString title_of(const RecordingFacts& facts) {
    return facts.lesson + ", " + facts.played;
}

std::array<QString, 2> headings_of(const RecordingFacts& one, const RecordingFacts& other) {
    const auto words = [](const RecordingFacts& facts) {
        const QString result = facts.result.isEmpty() ? QString() : facts.result + ", ";
        return result + title_of(facts);
    };
    const bool alike = words(one) == words(other);
    // What tells them apart comes first: the end of a long heading may not be seen.
    const auto heading = [&](int number, const RecordingFacts& facts) {
        const QString file = alike ? " (" + to_text(facts.file.filename()) + ")" : QString();
        return QString::number(number) + ": " + words(facts) + file;
    };
    return {heading(1, one), heading(2, other)};
}

RecordingDialog::RecordingDialog(const fs::path& folder, QWidget* parent, fs::path shown)
    : QDialog(parent), folder_(folder), shown_(std::move(shown)), table_(new QTableWidget) {
    setWindowTitle(shown_.empty() ? Words::tr("Open recording") : Words::tr("Compare with"));
    resize_on_screen(*this, {720, 460});
    table_->setObjectName("recordings");
    table_->setAccessibleName(Words::tr("Recordings"));
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->verticalHeader()->hide();
    auto* column = new QVBoxLayout(this);
    heading_ = new QLabel(Words::tr("Recordings of lessons and plays, the newest first:"));
    column->addWidget(heading_);
    column->addWidget(table_, 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    open_ = buttons->addButton(Words::tr("&Open"), QDialogButtonBox::AcceptRole);
    open_->setDefault(true);
    open_->setObjectName("openRecording");
    auto* file = buttons->addButton(Words::tr("Another &file…"), QDialogButtonBox::ActionRole);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, [this] { choose_row(); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(file, &QPushButton::clicked, this, [this] { ask_for_file(); });
    connect(table_, &QTableWidget::cellActivated, this, [this] { choose_row(); });
    fill();
}

void RecordingDialog::fill() {
    std::error_code ignored;
    for (const fs::path& recording : recordings_in(folder_))
        if (shown_.empty() || !fs::equivalent(recording, shown_, ignored))
            listed_.push_back(facts_of(recording));
    const QStringList headers{Words::tr("Lesson"), Words::tr("Played"),         Words::tr("Length"),
                              Words::tr("Result"), Words::tr("Name or number"), Words::tr("File")};
    table_->setColumnCount(static_cast<int>(headers.size()));
    table_->setHorizontalHeaderLabels(headers);
    table_->setRowCount(static_cast<int>(listed_.size()));
    for (int row = 0; row < table_->rowCount(); ++row) {
        const RecordingFacts& facts = listed_[static_cast<std::size_t>(row)];
        const QString name = to_text(facts.file.filename());
        const QStringList texts{facts.lesson, facts.played,  clock_text(5999.9),
                                facts.result, facts.trainee, name};
        for (int column = 0; column < texts.size(); ++column)
            table_->setItem(row, column, new QTableWidgetItem(texts[column]));
        table_->item(row, file_column)->setToolTip(as_plain(to_text(facts.file)));
    }
    table_->resizeColumnsToContents();
    widen_to_columns(*this, *table_);
    table_->horizontalHeader()->setStretchLastSection(true);
    // Room for a length was all that they were for.
    for (int row = 0; row < table_->rowCount(); ++row)
        table_->item(row, length_column)->setText({});
    read_lengths(0);
    connect(table_, &QTableWidget::itemSelectionChanged, this,
            [this] { open_->setEnabled(!table_->selectedItems().isEmpty()); });
    open_->setEnabled(false);
    row_to_choose() < 0 ? table_->setCurrentItem(nullptr) : table_->selectRow(row_to_choose());
    if (listed_.empty())
        heading_->setText(shown_.empty() ? Words::tr("There is no recording here yet:")
                                         : Words::tr("There is no other recording here yet:"));
}

int RecordingDialog::row_to_choose() const {
    if (shown_.empty()) return listed_.empty() ? -1 : 0;
    const QString lesson = facts_of(shown_).lesson;
    const std::optional<std::uint64_t> patient = patient_of(shown_);
    const auto alike = std::ranges::find_if(listed_, [&](const RecordingFacts& facts) {
        return patient && facts.lesson == lesson && patient_of(facts.file) == patient;
    });
    return alike == listed_.end() ? -1 : static_cast<int>(alike - listed_.begin());
}

void RecordingDialog::read_lengths(std::size_t row) {
    if (row >= listed_.size()) return;
    BackgroundJob::Callbacks callbacks;
    callbacks.failed = [](const Failure&) {};  // it is told when the recording is opened
    callbacks.ended = [this, row] { read_lengths(row + 1); };
    reading_ = std::make_unique<BackgroundJob>(
        [this, row, file = listed_[row].file](Job& job) -> std::function<void()> {
            const double length_s =
                played_s(read_recording(file, RecordingPart::commands, job.stop_token()));
            return [this, row, length_s] {
                table_->item(static_cast<int>(row), length_column)->setText(clock_text(length_s));
            };
        },
        std::move(callbacks));
}

void RecordingDialog::choose_row() {
    const int row = table_->currentRow();
    if (row < 0 || !open_->isEnabled()) return;
    chosen_ = listed_[static_cast<std::size_t>(row)].file;
    accept();
}

void RecordingDialog::ask_for_file() {
    const QString path = QFileDialog::getOpenFileName(this, windowTitle(), to_text(folder_),
                                                      Words::tr("Recordings (*.hrec)"));
    if (path.isEmpty()) return;
    chosen_ = to_path(path);
    accept();
}

}  // namespace hepatica
