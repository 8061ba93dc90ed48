// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/attempts_dialog.h"

#include <QComboBox>
#include <QDateTime>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/base/three_digits.h"
#include "ui/core_words.h"
#include "ui/date_words.h"
#include "ui/lesson_words.h"
#include "ui/on_screen.h"
#include "ui/paths.h"
#include "ui/plain_text.h"
#include "ui/plot_panel.h"
#include "ui/words.h"

namespace hepatica {
namespace {

struct Column {
    enum { number, ended, result, reference, name, first_quantity };
};

constexpr int least_axis = 5;

// Results are stored in UTC and shown in local time.
QString local_time(const std::string& utc) {
    const QDateTime time = QDateTime::fromString(QString::fromStdString(utc), Qt::ISODate);
    return time.isValid() ? date_words(time.toLocalTime()) : QString::fromStdString(utc);
}

QTableWidgetItem* text_item(const QString& text) {
    auto* item = new QTableWidgetItem(text);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    return item;
}

// A count as a whole number; else about three significant digits without an exponent: at most four
// decimals, and before the decimal sign as many as are shown elsewhere: "0.0123", "1.23", "1230".
QString in_figures(Quantity quantity, double value) {
    if (is_count(quantity)) return QLocale().toString(value, 'f', 0);
    value = in_three_digits(value);
    const double order = value == 0.0 ? 0.0 : std::floor(std::log10(std::abs(value)));
    return QLocale().toString(value, 'f', static_cast<int>(std::clamp(2.0 - order, 0.0, 4.0)));
}

}  // namespace

Chart learning_curve(const std::vector<Attempt>& attempts, Quantity quantity, FlowUnits units) {
    const QuantityWords& words = words_of(quantity);
    const std::string in = shown_value(quantity, 0.0, units).unit;
    const std::string unit = in.empty() ? "" : " (" + in + ")";
    const auto shown = [&](double value) { return shown_value(quantity, value, units).value; };
    Chart chart{Words::id("Learning curve"),
                Words::id("Attempt"),
                words.words + unit,
                {Curve{words.words, {}, {}}}};
    for (std::size_t i = 0; i < attempts.size(); ++i) {
        // The line joins the passed ones alone: one that failed early would look like progress.
        const bool passed = attempts[i].passed;
        chart.curves[0].x.push_back(static_cast<double>(i + 1));
        chart.curves[0].y.push_back(passed ? shown(attempts[i].value(quantity)) : std::nan(""));
    }
    // At least least_axis wide, so that the axis is labelled in whole attempts.
    if (attempts.size() < static_cast<std::size_t>(least_axis)) {
        chart.curves[0].x.push_back(least_axis);
        chart.curves[0].y.push_back(std::nan(""));
    }
    if (const auto band = band_of(attempts, quantity)) {
        const std::vector<double> ends{0.0, static_cast<double>(attempts.size())};
        const double most = shown(band->most), least = shown(band->least);
        chart.curves.push_back({Words::id("reference"), ends, {most, most}});
        if (least != most) chart.curves.push_back({Words::id("its least"), ends, {least, least}});
    }
    Curve failed{Words::id("✗ not passed"), {}, {}, true};
    for (std::size_t i = 0; i < attempts.size(); ++i) {
        if (attempts[i].passed) continue;
        failed.x.push_back(static_cast<double>(i + 1));
        failed.y.push_back(shown(attempts[i].value(quantity)));
    }
    if (!failed.x.empty()) chart.curves.push_back(std::move(failed));
    return chart;
}

AttemptsDialog::AttemptsDialog(Ways ways, QWidget* parent)
    : QDialog(parent),
      ways_(std::move(ways)),
      title_(new QLabel),
      table_(new QTableWidget),
      whose_(new QComboBox),
      quantity_(new QComboBox),
      plot_(new PlotView),
      look_back_(new QPushButton(Words::tr("Look &back on it"))),
      save_(new QPushButton(Words::tr("Save as &CSV…"))) {
    setWindowTitle(Words::tr("Attempts"));
    resize_on_screen(*this, {860, 560});
    title_->setObjectName("attemptsTitle");
    title_->setWordWrap(true);
    table_->setObjectName("attempts");
    table_->setAccessibleName(Words::tr("Attempts"));
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->verticalHeader()->hide();
    whose_->setObjectName("attemptsWhose");
    whose_->setAccessibleName(Words::tr("Whose attempts"));
    quantity_->setObjectName("attemptsQuantity");
    quantity_->setAccessibleName(Words::tr("Quantity of the learning curve"));
    look_back_->setObjectName("attemptsLookBack");
    save_->setObjectName("attemptsSave");
    auto* column = new QVBoxLayout(this);
    column->addWidget(title_);
    column->addWidget(table_, 1);
    auto* row = new QHBoxLayout;
    row->addWidget(new QLabel(Words::tr("Learning curve of")));
    row->addWidget(quantity_);
    row->addWidget(whose_);
    row->addStretch(1);
    column->addLayout(row);
    column->addWidget(plot_, 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->addButton(look_back_, QDialogButtonBox::ActionRole);
    buttons->addButton(save_, QDialogButtonBox::ActionRole);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::hide);
    connect(whose_, &QComboBox::currentIndexChanged, this, [this] { show_attempts(); });
    connect(quantity_, &QComboBox::currentIndexChanged, this, [this] { draw_curve(); });
    connect(save_, &QPushButton::clicked, this, [this] { ways_.save(to_csv(attempts_.list)); });
    connect(look_back_, &QPushButton::clicked, this, [this] {
        const int chosen = table_->currentRow();
        if (chosen < 0) return;
        hide();
        const auto line = static_cast<std::size_t>(chosen);
        const std::size_t ended = attempts_.list.size();
        ways_.look_back(line < ended ? attempts_.list[line].recording
                                     : interrupted_[line - ended].recording);
    });
    connect(table_, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* item) {
        if (item->column() == Column::reference)
            mark(item->row(), item->checkState() == Qt::Checked);
    });
}

const Chart& AttemptsDialog::chart() const {
    return plot_->chart();
}

void AttemptsDialog::show_lesson(const LessonKey& lesson, const std::filesystem::path& folder,
                                 const std::string& name,
                                 std::vector<std::filesystem::path> interrupted) {
    lesson_ = lesson;
    folder_ = folder;
    without_result_ = std::move(interrupted);
    offer_names(name);
    show_attempts();
    widen_to_columns(*this, *table_);  // the quantity that failed may stand in the last one
    show();
    raise();
}

void AttemptsDialog::set_units(FlowUnits units) {
    if (std::exchange(units_, units) == units || isHidden()) return;
    fill_table();
    draw_curve();
}

void AttemptsDialog::offer_names(const std::string& name) {
    const std::vector<std::string> names = names_in(attempts_at(lesson_, folder_).list);
    named_ = !names.empty();
    const QSignalBlocker quiet(whose_);
    whose_->clear();
    whose_->addItem(Words::tr("of everybody"), QString());
    for (const std::string& one : names) {
        const QString text = QString::fromStdString(one);
        whose_->addItem(Words::tr("of %1").arg(text), text);
        if (one == name) whose_->setCurrentIndex(whose_->count() - 1);
    }
    whose_->setVisible(named_);
}

// The attempts at the lesson of the chosen trainee.
void AttemptsDialog::show_attempts() {
    attempts_ = attempts_at(lesson_, folder_);
    const std::string whose = whose_->currentData().toString().toStdString();
    const auto of_another = [&](const Attempt& attempt) {
        return !whose.empty() && attempt.name != whose;
    };
    interrupted_.clear();
    std::ranges::copy_if(attempts_.list, std::back_inserter(interrupted_), was_interrupted);
    std::erase_if(attempts_.list, was_interrupted);
    std::erase_if(interrupted_, of_another);
    for (const std::filesystem::path& recording : without_result_)
        interrupted_.emplace_back().recording = recording;
    const std::size_t of_everybody = attempts_.list.size();
    std::erase_if(attempts_.list, of_another);
    choose_quantities();
    fill_table();
    draw_curve();
    const std::size_t count = attempts_.list.size();
    QString text = Words::tr(
                       "<b>%1</b>: %n attempt(s). Tick those of an instructor: they are the band "
                       "in the learning curve.",
                       nullptr, static_cast<int>(count))
                       .arg(translated(lesson_.name).toHtmlEscaped());
    if (count < of_everybody)
        text += " " + Words::tr("Of all %1 attempts these are shown: %2.")
                          .arg(of_everybody)
                          .arg(whose_->currentText().toHtmlEscaped());
    for (const std::string& words : attempts_.passed_over)
        text += "<br>" + Words::tr("Left out: %1").arg(translated(words).toHtmlEscaped());
    title_->setText(text);
}

// The one that was chosen stays, as where the attempts of another trainee are shown.
void AttemptsDialog::choose_quantities() {
    const auto index = static_cast<std::size_t>(std::max(0, quantity_->currentIndex()));
    const std::vector<Quantity> before = std::exchange(quantities_, {});
    for (const QuantityWords& words : quantities()) {
        if (words.quantity >= Quantity::step_time_s) break;
        for (const Attempt& attempt : attempts_.list) {
            const double value = attempt.value(words.quantity);
            if (!std::isfinite(value) || value == 0.0) continue;
            quantities_.push_back(words.quantity);
            break;
        }
    }
    const QSignalBlocker quiet(quantity_);
    quantity_->clear();
    for (const Quantity quantity : quantities_)
        quantity_->addItem(Words::tr(words_of(quantity).words));
    if (index >= before.size()) return;
    const auto again = std::ranges::find(quantities_, before[index]);
    if (again != quantities_.end())
        quantity_->setCurrentIndex(static_cast<int>(again - quantities_.begin()));
}

void AttemptsDialog::fill_table() {
    const QSignalBlocker quiet(table_);
    QStringList heads{Words::tr("Attempt"), Words::tr("Ended"), Words::tr("Result"),
                      Words::tr("Reference"), Words::tr("Name")};
    for (const Quantity quantity : quantities_) {
        const QuantityWords& words = words_of(quantity);
        const QString name = Words::tr(words.words);
        const QString unit = QString::fromStdString(shown_value(quantity, 0.0, units_).unit);
        heads << (unit.isEmpty() ? name : QString("%1 (%2)").arg(name, unit));
    }
    table_->clear();
    table_->setColumnCount(static_cast<int>(heads.size()));
    table_->setHorizontalHeaderLabels(heads);
    const int ended = static_cast<int>(attempts_.list.size());
    table_->setRowCount(ended + static_cast<int>(interrupted_.size()));
    for (int row = 0; row < table_->rowCount(); ++row)
        row < ended ? fill_row(row, attempts_.list[static_cast<std::size_t>(row)])
                    : fill_interrupted(row, interrupted_[static_cast<std::size_t>(row - ended)]);
    table_->setColumnHidden(Column::name, !named_);
    table_->resizeColumnsToContents();
    if (table_->rowCount() > 0) table_->selectRow(ended > 0 ? ended - 1 : 0);
    look_back_->setEnabled(table_->rowCount() > 0);
    save_->setEnabled(ended > 0);
}

void AttemptsDialog::fill_row(int row, const Attempt& attempt) {
    table_->setItem(row, Column::number, text_item(QString::number(row + 1)));
    table_->setItem(row, Column::ended, text_item(local_time(attempt.ended_at)));
    auto* outcome = text_item(attempt.passed ? Words::tr("✓ passed") : Words::tr("✗ not passed"));
    QStringList why;
    for (const std::string& reason : attempt.reasons) why << translated(reason);
    outcome->setToolTip(as_plain(why.join("\n")));
    table_->setItem(row, Column::result, outcome);
    auto* box = new QTableWidgetItem;
    box->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    box->setCheckState(attempt.reference ? Qt::Checked : Qt::Unchecked);
    table_->setItem(row, Column::reference, box);
    table_->setItem(row, Column::name, text_item(QString::fromStdString(attempt.name)));
    for (std::size_t k = 0; k < quantities_.size(); ++k) {
        const double value =
            shown_value(quantities_[k], attempt.value(quantities_[k]), units_).value;
        auto* item = text_item(std::isfinite(value) ? in_figures(quantities_[k], value) : "");
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        table_->setItem(row, Column::first_quantity + static_cast<int>(k), item);
    }
}

// An interrupted attempt has no number, because it is no point of the curve.
void AttemptsDialog::fill_interrupted(int row, const Attempt& attempt) {
    for (int column = 0; column < table_->columnCount(); ++column)
        table_->setItem(row, column, text_item({}));
    table_->setItem(row, Column::ended, text_item(local_time(attempt.ended_at)));
    table_->setItem(row, Column::name, text_item(QString::fromStdString(attempt.name)));
    auto* outcome = text_item(Words::tr("interrupted"));
    outcome->setToolTip(Words::tr(
        "The play ended before the lesson did: it can be looked back on, and counts as no "
        "attempt."));
    table_->setItem(row, Column::result, outcome);
}

void AttemptsDialog::draw_curve() {
    const int chosen = quantity_->currentIndex();
    plot_->set_chart(chosen < 0
                         ? Chart{}
                         : learning_curve(attempts_.list,
                                          quantities_[static_cast<std::size_t>(chosen)], units_));
}

void AttemptsDialog::mark(int row, bool is_reference) {
    Attempt& attempt = attempts_.list[static_cast<std::size_t>(row)];
    if (attempt.reference == is_reference) return;
    attempt.reference = is_reference;
    try {
        // Who played it may have given his name since it was listed.
        mark_reference(attempt.recording, is_reference);
    } catch (...) {
        attempt.reference = !is_reference;
        fill_table();
        ways_.failed(std::current_exception());
    }
    draw_curve();
}

}  // namespace hepatica
