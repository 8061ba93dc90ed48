// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/results_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/core_words.h"
#include "ui/course_dialog.h"
#include "ui/on_screen.h"
#include "ui/words.h"

namespace hepatica {
namespace {

QString in_cell(const LessonResult& result) {
    if (result.attempts == 0) return "";
    const QString attempts = Words::tr("%n attempt(s)", nullptr, result.attempts);
    if (!result.passed) return "✗ " + attempts;
    return Words::tr("✓ %1 s, %2").arg(QLocale().toString(*result.best_s, 'f', 1), attempts);
}

}  // namespace

ResultsDialog::ResultsDialog(std::function<void(const std::string& csv)> save, QWidget* parent)
    : QDialog(parent),
      title_(new QLabel),
      nobody_(new QLabel(Words::tr("No attempt at a lesson has ended yet. Each one is counted "
                                   "here once it has, under the name or number at the foot "
                                   "of the panel Lesson."))),
      table_(new QTableWidget),
      save_(new QPushButton(Words::tr("Save as &CSV…"))) {
    setWindowTitle(Words::tr("Results of all"));
    resize_on_screen(*this, {1000, 480});
    title_->setObjectName("resultsTitle");
    title_->setWordWrap(true);
    nobody_->setObjectName("resultsNobody");
    nobody_->setWordWrap(true);
    nobody_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    table_->setObjectName("results");
    table_->setAccessibleName(Words::tr("Results of all"));
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table_->verticalHeader()->hide();
    save_->setObjectName("resultsSave");
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->addButton(save_, QDialogButtonBox::ActionRole);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::hide);
    connect(save_, &QPushButton::clicked, this, [this, save] { save(to_csv(results_)); });
    auto* column = new QVBoxLayout(this);
    column->addWidget(title_);
    column->addWidget(nobody_, 1);
    column->addWidget(table_, 1);
    column->addWidget(buttons);
}

void ResultsDialog::show_results(const std::string& course, CourseResults results) {
    results_ = std::move(results);
    title_->setText(Words::tr("<b>%1</b>: who passed what by the marks of the course, in how many "
                              "attempts. The time is the shortest of those that passed.")
                        .arg(course_title(course).toHtmlEscaped()));
    const bool anybody = !results_.trainees.empty();
    nobody_->setVisible(!anybody);
    table_->setVisible(anybody);
    save_->setEnabled(anybody);
    fill();
    show();
    raise();
}

void ResultsDialog::fill() {
    QStringList heads{Words::tr("Name or number"), Words::tr("Passed")};
    for (const std::string& lesson : results_.lessons) heads << translated(lesson);
    table_->clear();
    table_->setColumnCount(static_cast<int>(heads.size()));
    table_->setHorizontalHeaderLabels(heads);
    table_->setRowCount(static_cast<int>(results_.trainees.size()));
    for (int row = 0; row < table_->rowCount(); ++row) {
        const TraineeResults& trainee = results_.trainees[static_cast<std::size_t>(row)];
        const QString name = trainee.name.empty() ? Words::tr("without a name")
                                                  : QString::fromStdString(trainee.name);
        const auto passed = std::ranges::count_if(trainee.lessons, &LessonResult::passed);
        table_->setItem(row, 0, new QTableWidgetItem(name));
        table_->setItem(
            row, 1,
            new QTableWidgetItem(Words::tr("%1 of %2").arg(passed).arg(trainee.lessons.size())));
        int column = 2;
        for (const LessonResult& result : trainee.lessons)
            table_->setItem(row, column++, new QTableWidgetItem(in_cell(result)));
    }
    table_->resizeColumnsToContents();
}

}  // namespace hepatica
