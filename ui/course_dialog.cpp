// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/course_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "core/lesson/lesson_file.h"
#include "ui/core_words.h"
#include "ui/on_screen.h"
#include "ui/words.h"

namespace hepatica {
namespace {

QStringList heads_of_table() {
    return {Words::tr("Lesson"), Words::tr("Pass marks of the course"), Words::tr("Attempts"),
            Words::tr("Standing")};
}

QString marks_of(const CourseLine& line) {
    QStringList words;
    for (const Predicate& mark : line.pass) words << translated(to_words(mark, {}));
    return words.empty() ? Words::tr("the lesson's own") : words.join("\n");
}

QString standing_of(const CourseLine& line) {
    if (line.passed) return Words::tr("✓ passed");
    if (line.passed_earlier) return Words::tr("passed earlier, before this course");
    return line.attempts > 0 ? Words::tr("✗ not passed yet") : Words::tr("not tried yet");
}

}  // namespace

CourseDialog::CourseDialog(Begin begin, std::function<void()> own, QWidget* parent)
    : QDialog(parent),
      begin_(std::move(begin)),
      title_(new QLabel),
      table_(new QTableWidget),
      start_(new QPushButton(Words::tr("&Begin the lesson"))),
      own_(new QPushButton(Words::tr("The program's &own course"))) {
    setWindowTitle(Words::tr("Course"));
    resize_on_screen(*this, {720, 420});
    title_->setObjectName("courseTitle");
    table_->setObjectName("course");
    table_->setAccessibleName(Words::tr("Lessons of the course"));
    const QStringList heads = heads_of_table();
    table_->setColumnCount(static_cast<int>(heads.size()));
    table_->setHorizontalHeaderLabels(heads);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
    start_->setObjectName("courseBegin");
    start_->setDefault(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->addButton(start_, QDialogButtonBox::ActionRole);
    own_->setObjectName("courseOwn");
    buttons->addButton(own_, QDialogButtonBox::ResetRole);
    connect(own_, &QPushButton::clicked, this, own);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::hide);
    const auto start = [this] {
        const int row = table_->currentRow();
        if (row < 0) return;
        hide();
        begin_(lines_[static_cast<std::size_t>(row)]);
    };
    connect(start_, &QPushButton::clicked, this, start);
    connect(table_, &QTableWidget::cellDoubleClicked, this, start);
    auto* column = new QVBoxLayout(this);
    column->addWidget(title_);
    column->addWidget(table_, 1);
    column->addWidget(buttons);
}

QString course_title(const std::string& name) {
    static const std::string own = course_of(built_in_course(), "course").name;
    return name == own ? translated(name) : QString::fromStdString(name);
}

QString whose_attempts(const std::string& trainee) {
    return trainee.empty() ? Words::tr("everybody here") : QString::fromStdString(trainee);
}

void CourseDialog::show_course(const std::string& name, std::vector<CourseLine> lines,
                               const std::string& whose, bool own) {
    lines_ = std::move(lines);
    own_->setVisible(!own);
    const auto passed = std::ranges::count_if(lines_, &CourseLine::passed);
    const QString title = course_title(name).toHtmlEscaped(), done = QString::number(passed),
                  of = QString::number(lines_.size());
    // All placeholders at once, here and elsewhere: a name may contain "%2".
    QString text = Words::tr("<b>%1</b>: %2 of %3 lessons passed by %4")
                       .arg(title, done, of, whose_attempts(whose).toHtmlEscaped());
    if (lines_.empty())
        text = Words::tr("<b>%1</b> holds no lesson yet: Lesson > Edit course adds some")
                   .arg(QString::fromStdString(name).toHtmlEscaped());
    title_->setText(text);
    start_->setEnabled(!lines_.empty());
    table_->setRowCount(static_cast<int>(lines_.size()));
    for (int row = 0; row < table_->rowCount(); ++row) {
        const CourseLine& line = lines_[static_cast<std::size_t>(row)];
        table_->setItem(row, 0, new QTableWidgetItem(translated(line.title)));
        table_->setItem(row, 1, new QTableWidgetItem(marks_of(line)));
        table_->setItem(row, 2, new QTableWidgetItem(QString::number(line.attempts)));
        table_->setItem(row, 3, new QTableWidgetItem(standing_of(line)));
    }
    table_->resizeColumnToContents(0);
    table_->resizeColumnToContents(3);
    const auto next = std::ranges::find(lines_, false, &CourseLine::passed);
    if (!lines_.empty())
        table_->selectRow(next == lines_.end() ? 0 : static_cast<int>(next - lines_.begin()));
    show();
    raise();
    // So that the first arrow key already chooses.
    if (!lines_.empty()) table_->setFocus();
}

}  // namespace hepatica
