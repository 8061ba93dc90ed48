// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/core_words.h"
#include "ui/lesson_words.h"
#include "ui/plain_text.h"
#include "ui/push_button.h"
#include "ui/words.h"

namespace hepatica {
namespace {

QLabel* add_label(QVBoxLayout& column, const char* name) {
    auto* label = new QLabel;
    label->setObjectName(name);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column.addWidget(label);
    return label;
}

// For quantities that only grow, such as time: once above an upper bound they stay there.
bool missed_for_good(const BoundStanding& mark) {
    return mark.predicate.quantity < Quantity::dose_target_share && !mark.predicate.at_least &&
           !std::isnan(mark.value) && !mark.kept;
}

// Row of a table: a symbol, which does not rely on colour, the bound, and the present value.
QString row_of(const BoundStanding& bound, const std::vector<std::string>& marks, FlowUnits units,
               const char* kept, const char* broken) {
    const bool known = !std::isnan(bound.value);
    QString now = known ? translated(to_words_beside(bound.predicate, bound.value, units)) : "";
    // Else it would read "no vessels held by hand or tool 1".
    if (known && allows_none(bound.predicate)) now = Words::tr("counted: %1").arg(now);
    return QString(
               "<tr><td width='18'>%1</td><td>%2</td>"
               "<td align='right'>&nbsp;<b>%3</b></td></tr>")
        .arg(QString::fromUtf8(bound.kept ? kept : broken),
             with_units_beside(translated(to_words(bound.predicate, marks, units))).toHtmlEscaped(),
             with_units_beside(now).toHtmlEscaped());
}

QString table_of(const QString& title, const std::vector<BoundStanding>& bounds,
                 const std::vector<std::string>& marks, FlowUnits units, const char* kept,
                 const char* broken) {
    if (bounds.empty()) return "";
    QString html = "<p style='margin:0'>" + title + "</p><table width='100%'>";
    for (const BoundStanding& bound : bounds)
        html += row_of(bound, marks, units, kept, missed_for_good(bound) ? "✗" : broken);
    return html + "</table>";
}

// The lesson's own and those of the present step: a step that is over can break none any more.
std::vector<BoundStanding> limits_in_force(const LessonStanding& standing, const Lesson& lesson) {
    const std::vector<BoundStanding>& all = standing.limits;
    const std::size_t own = std::min(lesson.limits.size(), all.size());
    std::size_t present = own;
    for (std::size_t i = 0; i < std::min(standing.step, lesson.steps.size()); ++i)
        present += lesson.steps[i].limits.size();
    std::vector<BoundStanding> shown(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(own));
    if (present < all.size())
        shown.insert(shown.end(), all.begin() + static_cast<std::ptrdiff_t>(present), all.end());
    return shown;
}

}  // namespace

LessonPanel::LessonPanel(Ways ways, QWidget* parent)
    : QWidget(parent),
      tell_step_(ways.step),
      by_keys_(ways.by_keys),
      tool_and_key_(ways.tool_and_key) {
    auto* column = new QVBoxLayout(this);
    column->setSpacing(8);
    title_ = add_label(*column, "lessonTitle");
    // Above everything whose height changes.
    auto* play_row = new QHBoxLayout;
    add_button(*play_row, Words::tr("Be&gin again"), "lessonAgain", ways.again);
    add_button(*play_row, Words::tr("Leav&e"), "lessonLeave", ways.leave);
    column->addLayout(play_row);
    about_ = add_label(*column, "quiet");
    about_->setTextFormat(Qt::PlainText);
    doubts_ = add_label(*column, "lessonPlaceDoubts");
    clock_ = add_label(*column, "lessonClock");
    step_ = add_label(*column, "lessonStep");
    step_->setTextFormat(Qt::PlainText);
    tool_ = add_label(*column, "lessonStepTool");
    tool_->setTextFormat(Qt::PlainText);
    QFont bold = tool_->font();  // it says why a goal that is met does not count
    bold.setBold(true);
    tool_->setFont(bold);
    goal_ = add_label(*column, "lessonGoal");
    hold_ = new QProgressBar;
    hold_->setObjectName("lessonHold");
    hold_->setTextVisible(false);
    hold_->setRange(0, 100);
    hold_->setAccessibleName(Words::tr("How long the goal has been held"));
    column->addWidget(hold_);
    hint_ = add_label(*column, "lessonHint");
    hint_->setTextFormat(Qt::PlainText);
    auto* first_row = new QHBoxLayout;
    hint_button_ = add_button(*first_row, Words::tr("H&int"), "lessonHintButton", [this] {
        hinted_step_ = shown_step_;
        hint_->setVisible(true);
        hint_button_->setEnabled(false);
    });
    column->addLayout(first_row);
    limits_ = add_label(*column, "lessonLimits");
    pass_ = add_label(*column, "lessonPass");
    end_ = add_label(*column, "lessonEnd");
    course_ = add_label(*column, "lessonCourse");
    course_->setTextFormat(Qt::PlainText);
    course_->hide();
    auto* next_row = new QHBoxLayout;
    next_ = add_button(*next_row, {}, "lessonNext", [run = ways.next] { run(); });
    column->addLayout(next_row);
    report_ = new QPushButton(Words::tr("Write a &report…"));
    report_->setObjectName("lessonReport");
    connect(report_, &QPushButton::clicked, this, [run = ways.report] { run(); });
    column->addWidget(report_);
    look_back_ = new QPushButton(Words::tr("Look &back on it"));
    look_back_->setObjectName("lessonLookBack");
    connect(look_back_, &QPushButton::clicked, this, [run = ways.look_back] { run(); });
    column->addWidget(look_back_);
    attempts_ = new QPushButton(Words::tr("All &attempts…"));
    attempts_->setObjectName("lessonAttempts");
    connect(attempts_, &QPushButton::clicked, this, [run = ways.attempts] { run(); });
    column->addWidget(attempts_);
    column->addLayout(make_name());
    // The next key is one of the play again.
    connect(name_, &QLineEdit::returnPressed, name_, &QWidget::clearFocus);
    connect(name_, &QLineEdit::editingFinished, this, [this, run = ways.name] {
        if (run) run(name_->text().simplified());
    });
    column->addStretch(1);
}

QLayout* LessonPanel::make_name() {
    name_ = new QLineEdit;
    name_->setObjectName("lessonName");
    name_->setPlaceholderText(Words::tr("none needed"));
    name_->setMaxLength(100);
    name_->setToolTip(Words::tr(
        "Stands in the results of attempts that end from now on, in that of the one that has "
        "just ended if it names nobody, and in their reports. Leave it empty, and nobody "
        "is named."));
    auto* label = new QLabel(Words::tr("Name or number"));
    label->setBuddy(name_);
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(name_, 1);
    return row;
}

void LessonPanel::set_next(const std::string& lesson) {
    next_lesson_ = lesson;
    // The lesson's name would widen the panel.
    next_->setText(Words::tr("&Next lesson"));
    next_->setToolTip(as_plain(translated(lesson)));
}

void LessonPanel::set_course_standing(const QString& words) {
    course_->setText(words);
}

void LessonPanel::set_name(const QString& name) {
    name_->setText(name);
}

void LessonPanel::begin(const Lesson& lesson, const std::vector<std::string>& doubts) {
    QStringList lines;
    for (const std::string& doubt : doubts) lines << "⚠ " + translated(doubt);
    doubts_->setTextFormat(Qt::PlainText);
    doubts_->setText(lines.join("\n"));
    doubts_->setVisible(!lines.isEmpty());
    lesson_ = lesson;
    hinted_step_ = static_cast<std::size_t>(-1);
    shown_step_ = 0;
    title_->setText("<b>" + translated(lesson.name).toHtmlEscaped() + "</b>");
    about_->setText(with_units_beside(translated(lesson.about)));
    about_->setVisible(!lesson.about.empty());
    const QString counted =
        lesson.scene.flow
            ? Words::tr(
                  "What a drug has reached is a share of the vessels' surface: of the "
                  "target's, or of all others, whatever their system.")
            : QString();
    for (QLabel* label : {goal_, limits_, pass_}) label->setToolTip(counted);
}

QString LessonPanel::about_clock(const LessonStanding& standing, bool clock_stands,
                                 InView in_view) const {
    const bool running = standing.outcome == LessonOutcome::running;
    if (!running && in_view == InView::review)
        return Words::tr(
            "The view looks back on this attempt; below is how it was judged. Nothing that you do "
            "changes it: \"Leave the review\" ends looking back, \"Begin again\" is a new "
            "attempt.");
    if (!running && in_view == InView::other)
        return Words::tr(
            "The play that was judged is left: \"Look back on it\" shows its recording.");
    if (!running)
        return Words::tr(
            "The play is paused as it was when it was judged, and what was in hand is put away. It "
            "goes on as soon as you do something.");
    if (clock_stands) return Words::tr("The clock stands: it runs from the first thing you do.");
    return Words::tr("Time: %1")
        .arg(with_units_beside(
            translated(to_words(Quantity::time_s, standing.metrics.time_s, units_))));
}

void LessonPanel::show_standing(const LessonStanding& standing, bool clock_stands, InView in_view) {
    const bool running = standing.outcome == LessonOutcome::running;
    clock_->setVisible(running || clock_stands || in_view != InView::play);
    clock_->setText(about_clock(standing, clock_stands, in_view));
    for (QWidget* widget : std::initializer_list<QWidget*>{step_, goal_, hold_, hint_button_})
        widget->setVisible(running);
    const QString missing = words_of_missing_tool(standing);
    tool_->setText(missing);
    tool_->setVisible(!missing.isEmpty());
    end_->setVisible(!running);
    report_->setVisible(!running);
    look_back_->setVisible(!running);
    attempts_->setVisible(!running && !trial_);
    next_->setVisible(!running && !next_lesson_.empty());
    course_->setVisible(!running && !course_->text().isEmpty());
    pass_->setVisible(running && !standing.pass.empty());
    limits_->setText(table_of(Words::tr("Limits"), limits_in_force(standing, lesson_),
                              lesson_.mark_names(), units_, "✓", "✗"));
    if (running)
        show_step(standing);
    else
        show_end(standing);
}

QString LessonPanel::words_of_step(std::size_t step) const {
    return Words::tr("Step %1 of %2: %3")
        .arg(step + 1)
        .arg(lesson_.steps.size())
        .arg(with_units_beside(translated(lesson_.steps[step].text)));
}

QString LessonPanel::words_of_missing_tool(const LessonStanding& standing) const {
    if (standing.outcome != LessonOutcome::running || !standing.tool_missing || !tool_and_key_)
        return {};
    const std::optional<LessonTool> tool = lesson_.steps[standing.step].tool;
    return tool ? Words::tr("This step is done with: %1").arg(tool_and_key_(*tool)) : QString();
}

void LessonPanel::show_step(const LessonStanding& standing) {
    const bool is_later = standing.step > std::exchange(shown_step_, standing.step);
    const LessonStep& step = lesson_.steps[standing.step];
    step_->setText(words_of_step(standing.step));
    // The eyes are on the vessels.
    if (is_later && tell_step_) tell_step_(step_->text());
    QString pass = table_of(Words::tr("Pass marks: so far, judged in the end"), standing.pass,
                            lesson_.mark_names(), units_, "✓", "·");
    if (std::ranges::any_of(standing.pass, missed_for_good))
        pass += "<p><b>" + Words::tr("It can no longer be passed: begin again, or practise on.") +
                "</b></p>";
    pass_->setText(pass);
    goal_->setText(
        table_of(Words::tr("Goal"), standing.goal, lesson_.mark_names(), units_, "●", "○"));
    hold_->setVisible(step.hold_s > 0.0);
    const double held_s = standing.steps[standing.step].held_s;
    if (step.hold_s > 0.0)
        hold_->setValue(static_cast<int>(100.0 * std::min(1.0, held_s / step.hold_s)));
    const QString keys = by_keys_ ? by_keys_(lesson_.tools) : QString();
    hint_->setText(with_units_beside(translated(step.hint)) +
                   (keys.isEmpty() ? keys : "\n" + keys));
    const bool open = hinted_step_ == standing.step;
    hint_->setVisible(open && !step.hint.empty());
    hint_button_->setEnabled(!open && !step.hint.empty());
}

// What was not reached, in bold the step that was to be done next.
QString LessonPanel::table_of_steps(const LessonStanding& standing) const {
    QString html = "<p style='margin:0'>" + Words::tr("Steps") + "</p><table width='100%'>";
    for (std::size_t i = 0; i < lesson_.steps.size(); ++i) {
        const bool reached = i < standing.step;
        const QString step = words_of_step(i).toHtmlEscaped();
        html += QString("<tr><td width='18'>%1</td><td>%2</td><td align='right'>&nbsp;%3</td></tr>")
                    .arg(reached ? "✓" : "✗", i == standing.step ? "<b>" + step + "</b>" : step,
                         reached ? Words::tr("reached") : Words::tr("not reached"));
    }
    return html + "</table>";
}

void LessonPanel::show_end(const LessonStanding& standing) {
    hint_->hide();
    const bool passed = standing.outcome == LessonOutcome::passed;
    QString html =
        "<p><b>" + (passed ? Words::tr("✓ Passed") : Words::tr("✗ Not passed")) + "</b></p>";
    for (const std::string& reason : reasons_in(standing, lesson_.mark_names(), units_))
        html += "<p>" + with_units_beside(translated(reason)).toHtmlEscaped() + "</p>";
    if (!passed) html += table_of_steps(standing);
    std::vector<BoundStanding> seen = standing.pass;  // judged only if the end was reached
    std::erase_if(seen, [](const BoundStanding& mark) { return std::isnan(mark.value); });
    html += table_of(Words::tr("Pass marks"), seen, lesson_.mark_names(), units_, "✓", "✗");
    if (const QString left = drug_on_its_way(standing, lesson_, units_); !left.isEmpty())
        html += "<p>" + with_units_beside(left).toHtmlEscaped() + "</p>";
    const LessonMetrics& metrics = standing.metrics;
    const auto said = [&](Quantity quantity, double value) {
        return with_units_beside(translated(to_words(quantity, value, units_)));
    };
    html +=
        "<p>" +
        Words::tr("%1, path %2, peak force %3")
            .arg(said(Quantity::time_s, metrics.time_s), said(Quantity::path_mm, metrics.path_mm),
                 said(Quantity::peak_force_mn, metrics.peak_force_mn)) +
        "</p>";
    if (trial_)
        html += "<p>" +
                Words::tr("Tried from the lesson editor: it is not kept among the attempts.") +
                "</p>";
    end_->setText(html);
}

}  // namespace hepatica
