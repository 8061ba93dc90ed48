// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_editor/steps_page.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "core/lesson/tool_in_hand.h"
#include "ui/decimal_spin_box.h"
#include "ui/lesson_editor/bounds_table.h"
#include "ui/lesson_editor/new_parts.h"
#include "ui/lesson_editor/tool_words.h"
#include "ui/words.h"

namespace hepatica {
namespace {

QString line_of(std::size_t index, const LessonStep& step) {
    return QString("%1. %2").arg(index + 1).arg(QString::fromStdString(step.text).simplified());
}

}  // namespace

StepsPage::StepsPage(Changes changes)
    : LessonPage(std::move(changes)),
      list_(new QListWidget),
      text_(new QPlainTextEdit),
      hint_(new QLineEdit),
      tool_(new QComboBox),
      hold_(new DecimalSpinBox(0.0, 3600.0, 0.0, 1, "s")),
      goal_(new BoundsTable(
          Words::tr("Goal: all of these at once"), "goal", {Quantity::force_mn, -1, true, 10.0},
          [this](const std::string& row, const std::vector<Predicate>& bounds) {
              set(row.empty() ? "" : "goal" + row, [&](LessonStep& step) { step.goal = bounds; });
          })),
      limits_(new BoundsTable(Words::tr("Limits while it lasts"), "stepLimit",
                              {Quantity::step_time_s, -1, false, 60.0},
                              [this](const std::string& row, const std::vector<Predicate>& bounds) {
                                  set(row.empty() ? "" : "limits" + row,
                                      [&](LessonStep& step) { step.limits = bounds; });
                              })) {
    auto* column = new QVBoxLayout(this);
    column->addWidget(make_list());
    column->addWidget(make_step(), 1);
}

QWidget* StepsPage::make_list() {
    auto* box = new QWidget;
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    list_->setObjectName("lessonSteps");
    list_->setAccessibleName(Words::tr("Steps of the lesson"));
    list_->setMaximumHeight(110);
    list_->setTextElideMode(Qt::ElideRight);
    connect(list_, &QListWidget::currentRowChanged, this, [this](int chosen) {
        if (chosen < 0) return;
        step_ = static_cast<std::size_t>(chosen);
        show_lesson(Lesson(shown_));
    });
    row->addWidget(list_, 1);
    auto* buttons = new QVBoxLayout;
    const auto button = [&](const QString& text, const char* name, auto run) {
        auto* made = new QPushButton(text);
        made->setObjectName(name);
        connect(made, &QPushButton::clicked, this, run);
        buttons->addWidget(made);
        return made;
    };
    button(Words::tr("&Add a step"), "stepAdd", [this] { add(); });
    remove_ = button(Words::tr("Re&move"), "stepRemove", [this] { remove(); });
    up_ = button(Words::tr("Earlie&r"), "stepUp", [this] { move(-1); });
    down_ = button(Words::tr("Lat&er"), "stepDown", [this] { move(1); });
    row->addLayout(buttons);
    return box;
}

QWidget* StepsPage::make_step() {
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    auto* form = new QFormLayout;
    text_->setObjectName("stepText");
    text_->setTabChangesFocus(true);
    text_->setMaximumHeight(64);
    connect(text_, &QPlainTextEdit::textChanged, this, [this] {
        set("text", [&](LessonStep& step) { step.text = text_->toPlainText().toStdString(); });
        if (QListWidgetItem* item = list_->item(static_cast<int>(step_)))
            item->setText(line_of(step_, shown_.steps[step_]));
    });
    form->addRow(Words::tr("Say"), text_);
    hint_->setObjectName("stepHint");
    hint_->setPlaceholderText(Words::tr("On demand. May be empty."));
    connect(hint_, &QLineEdit::textChanged, this, [this](const QString& text) {
        set("hint", [&](LessonStep& step) { step.hint = text.toStdString(); });
    });
    form->addRow(Words::tr("Hint"), hint_);
    make_tools();
    form->addRow(Words::tr("Done with"), tool_);
    hold_->setObjectName("stepHold");
    connect(hold_, &DecimalSpinBox::valueChanged, this, [this](double seconds) {
        set("hold", [&](LessonStep& step) { step.hold_s = seconds; });
    });
    form->addRow(Words::tr("Held for"), hold_);
    column->addLayout(form);
    column->addWidget(goal_);
    column->addWidget(limits_);
    column->addStretch(1);
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(content);
    return scroll;
}

// The tools that a step may ask for.
void StepsPage::make_tools() {
    tool_->setObjectName("stepTool");
    tool_->setToolTip(Words::tr("The goal counts only while this tool is in hand"));
    tool_->addItem(Words::tr("whatever is in hand"), -1);
    for (const auto& [tool, words] : tool_words)
        if (is_held(tool)) tool_->addItem(Words::tr(words), static_cast<int>(tool));
    connect(tool_, &QComboBox::activated, this, [this] {
        const int chosen = tool_->currentData().toInt();
        set("tool", [&](LessonStep& step) {
            step.tool = chosen < 0 ? std::nullopt : std::optional(static_cast<LessonTool>(chosen));
        });
    });
}

void StepsPage::fill(const Lesson& lesson) {
    shown_ = lesson;
    step_ = std::min(step_, lesson.steps.size() - 1);
    {
        const QSignalBlocker quiet(list_);
        while (list_->count() > static_cast<int>(lesson.steps.size())) delete list_->takeItem(0);
        while (list_->count() < static_cast<int>(lesson.steps.size())) list_->addItem("");
        for (std::size_t i = 0; i < lesson.steps.size(); ++i)
            list_->item(static_cast<int>(i))->setText(line_of(i, lesson.steps[i]));
        list_->setCurrentRow(static_cast<int>(step_));
    }
    remove_->setEnabled(lesson.steps.size() > 1);
    up_->setEnabled(step_ > 0);
    down_->setEnabled(step_ + 1 < lesson.steps.size());
    fill_step();
}

void StepsPage::fill_step() {
    const LessonStep& step = shown_.steps[step_];
    const QString text = QString::fromStdString(step.text);
    if (text_->toPlainText() != text) text_->setPlainText(text);
    const QString hint = QString::fromStdString(step.hint);
    if (hint_->text() != hint) hint_->setText(hint);
    tool_->setCurrentIndex(tool_->findData(step.tool ? static_cast<int>(*step.tool) : -1));
    hold_->setValue(step.hold_s);
    goal_->show_bounds(step.goal, shown_.mark_names());
    limits_->show_bounds(step.limits, shown_.mark_names());
}

void StepsPage::set(const std::string& field, const std::function<void(LessonStep&)>& change) {
    const std::size_t step = step_;
    const std::string name = field.empty() ? "" : "step" + std::to_string(step) + field;
    change_value(name, [&](Lesson& lesson) {
        change(lesson.steps[step]);
        shown_ = lesson;
    });
}

void StepsPage::add() {
    const std::size_t after = ++step_;
    change_shape([&](Lesson& lesson) {
        lesson.steps.insert(lesson.steps.begin() + static_cast<std::ptrdiff_t>(after),
                            new_step_in_words());
    });
    text_->setFocus();
    text_->selectAll();
}

void StepsPage::remove() {
    change_shape([&](Lesson& lesson) {
        lesson.steps.erase(lesson.steps.begin() + static_cast<std::ptrdiff_t>(step_));
    });
}

void StepsPage::move(int by) {
    const std::size_t from = step_;
    step_ = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(step_) + by);
    change_shape([&](Lesson& lesson) { std::swap(lesson.steps[from], lesson.steps[step_]); });
}

}  // namespace hepatica
