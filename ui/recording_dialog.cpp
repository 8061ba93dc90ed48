// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/recording_dialog.h"

#include <QDateTime>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableWidget>
#include <QVBoxLayout>
#include <utility>

#include "core/base/error.h"
#include "core/base/text_file.h"
#include "core/lesson/attempts.h"
#include "core/lesson/lesson_file.h"
#include "ui/core_words.h"
#include "ui/date_words.h"
#include "ui/on_screen.h"
#include "ui/paths.h"
#include "ui/plain_text.h"
#include "ui/recording_guard.h"
#include "ui/words.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

// The lesson in the file's name: a built-in lesson's id, or the name of its file.
QString lesson_in_name(const fs::path& recording) {
    static const QRegularExpression time("-\\d{8}-\\d{6}-\\d{3}$");
    const QString name = to_text(recording.stem()).remove(time);
    if (name == "play") return Words::tr("Free play");
    if (name == "lesson") return Words::tr("Lesson");  // tried before it had a file
    for (const BuiltInLesson& lesson : built_in_lessons())
        if (name == lesson.id) return translated(find_lesson(lesson.id).name);
    return name;
}

}  // namespace

RecordingFacts facts_of(const fs::path& recording) {
    const QDateTime played = QFileInfo(to_text(recording)).lastModified();
    RecordingFacts facts{recording, lesson_in_name(recording), date_words(played), {}};
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
        facts.result = attempt.passed ? Words::tr("✓ passed") : Words::tr("✗ not passed");
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
    const QStringList headers{Words::tr("Lesson"), Words::tr("Played"), Words::tr("Result"),
                              Words::tr("Name or number"), Words::tr("File")};
    table_->setColumnCount(static_cast<int>(headers.size()));
    table_->setHorizontalHeaderLabels(headers);
    table_->setRowCount(static_cast<int>(listed_.size()));
    for (int row = 0; row < table_->rowCount(); ++row) {
        const RecordingFacts& facts = listed_[static_cast<std::size_t>(row)];
        const QString name = to_text(facts.file.filename());
        const QStringList texts{facts.lesson, facts.played, facts.result, facts.trainee, name};
        for (int column = 0; column < texts.size(); ++column)
            table_->setItem(row, column, new QTableWidgetItem(texts[column]));
        table_->item(row, 4)->setToolTip(as_plain(to_text(facts.file)));
    }
    table_->resizeColumnsToContents();
    widen_to_columns(*this, *table_);
    table_->horizontalHeader()->setStretchLastSection(true);
    open_->setEnabled(!listed_.empty());
    if (!listed_.empty()) table_->selectRow(0);
    if (listed_.empty())
        heading_->setText(shown_.empty() ? Words::tr("There is no recording here yet:")
                                         : Words::tr("There is no other recording here yet:"));
}

void RecordingDialog::choose_row() {
    const int row = table_->currentRow();
    if (row < 0) return;
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
