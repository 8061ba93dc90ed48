// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_editor/bounds_table.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStandardItemModel>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/core_words.h"
#include "ui/decimal_spin_box.h"
#include "ui/lesson_editor/lesson_page.h"
#include "ui/words.h"

namespace hepatica {
namespace {

constexpr double largest_bound = 1e6;

QComboBox* quantity_choice(Quantity chosen, bool marks_known) {
    auto* choice = new QComboBox;
    auto* items = qobject_cast<QStandardItemModel*>(choice->model());
    for (const QuantityWords& words : quantities()) {
        choice->addItem(translated(words.words));
        // A quantity of a mark can be chosen only if the lesson has marks.
        items->item(choice->count() - 1)->setEnabled(!words.of_mark || marks_known);
    }
    choice->setCurrentIndex(static_cast<int>(chosen));
    // The longest entry would make the window wider than a small screen.
    choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    choice->setMinimumContentsLength(12);
    return choice;
}

QComboBox* mark_choice(const std::vector<std::string>& marks, int chosen) {
    auto* choice = new QComboBox;
    for (const std::string& mark : marks) choice->addItem(translated(mark));
    choice->setPlaceholderText(Words::tr("which mark?"));  // shown if the bound's mark was removed
    choice->setCurrentIndex(chosen);
    return choice;
}

// Decimals of the field: none for counts, three for shares, stretches, grams and for any bound that
// is no multiple of 0.1, else one.
int decimals_of(const QuantityWords& words, double bound) {
    using enum Quantity;
    switch (words.quantity) {
        case contacts:
        case joints_broken:
        case pieces_off:
        case drug_present:
        case holding:
            return 0;
        default:
            break;
    }
    const bool in_grams = words.unit[0] == 'g';  // for blood and drug a twentieth of a gram matters
    return *words.unit && !in_grams && bound * 10.0 == std::round(bound * 10.0) ? 1 : 3;
}

}  // namespace

void clear_rows(QBoxLayout& rows) {
    while (QLayoutItem* item = rows.takeAt(0)) {
        if (QWidget* widget = item->widget()) {
            widget->hide();
            widget->setParent(nullptr);
            widget->deleteLater();
        }
        delete item;
    }
}

BoundsTable::BoundsTable(const QString& title, const QString& name, const Predicate& first,
                         Changed changed)
    : name_(name), first_(first), changed_(std::move(changed)), rows_(new QVBoxLayout) {
    setObjectName(name);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    auto* head = new QHBoxLayout;
    head->addWidget(new QLabel("<b>" + title + "</b>"), 1);
    auto* add = new QPushButton(Words::tr("Add"));
    add->setObjectName(name + "Add");
    add->setAutoDefault(false);  // Enter in a field must not press it
    add->setAccessibleName(Words::tr("Add: %1").arg(title));
    connect(add, &QPushButton::clicked, this, [this] {
        bounds_.push_back(first_);
        fill();
        changed_("", bounds_);
    });
    head->addWidget(add);
    column->addLayout(head);
    column->addLayout(rows_);
}

void BoundsTable::show_bounds(const std::vector<Predicate>& bounds,
                              const std::vector<std::string>& marks) {
    bounds_ = bounds;
    marks_ = marks;
    fill();
}

void BoundsTable::fill() {
    filling_ = true;
    clear_rows(*rows_);
    for (std::size_t i = 0; i < bounds_.size(); ++i) rows_->addWidget(make_row(i));
    filling_ = false;
}

void BoundsTable::set(std::size_t index, const Predicate& bound, bool other_quantity) {
    if (filling_) return;  // a removed row loses the focus, and its bound may be gone
    bounds_[index] = bound;
    if (other_quantity) fill();  // the fields for mark and unit change
    changed_(std::to_string(index), bounds_);
}

void BoundsTable::choose_quantity(std::size_t index, int chosen) {
    Predicate now = bounds_[index];
    const std::string unit = words_of(now.quantity).unit;
    now.quantity = quantities()[static_cast<std::size_t>(chosen)].quantity;
    // The old number had another unit.
    if (words_of(now.quantity).unit != unit) now.bound = 1.0;
    now.mark = words_of(now.quantity).of_mark ? std::max(now.mark, 0) : -1;
    set(index, now, true);
}

QWidget* BoundsTable::make_row(std::size_t index) {
    const Predicate bound = bounds_[index];
    const QuantityWords& words = words_of(bound.quantity);
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    const auto add = [&](auto* field, const char* what, const QString& said) {
        field->setObjectName(name_ + QString::number(index) + what);
        field->setAccessibleName(said);
        line->addWidget(field);
        return field;
    };
    QComboBox* quantity = add(quantity_choice(bound.quantity, !marks_.empty()), "quantity",
                              Words::tr("What is measured"));
    line->setStretchFactor(quantity, 1);
    connect(quantity, &QComboBox::activated, this,
            [this, index](int chosen) { choose_quantity(index, chosen); });
    if (words.of_mark) {
        QComboBox* mark = add(mark_choice(marks_, bound.mark), "mark", Words::tr("Of which mark"));
        connect(mark, &QComboBox::activated, this, [this, index](int chosen) {
            Predicate now = bounds_[index];
            now.mark = chosen;
            set(index, now, false);
        });
    }
    auto* side = new QComboBox;
    side->addItems({Words::tr("at least"), Words::tr("at most")});
    side->setCurrentIndex(bound.at_least ? 0 : 1);
    add(side, "side", Words::tr("At least or at most"));
    connect(side, &QComboBox::activated, this, [this, index](int chosen) {
        Predicate now = bounds_[index];
        now.at_least = chosen == 0;
        set(index, now, false);
    });
    auto* number =
        add(new DecimalSpinBox(0.0, largest_bound, bound.bound, decimals_of(words, bound.bound),
                               QString::fromUtf8(words.unit)),
            "bound", Words::tr("The bound"));
    connect(number, &DecimalSpinBox::valueChanged, this, [this, index](double value) {
        if (filling_) return;
        Predicate now = bounds_[index];
        now.bound = value;
        set(index, now, false);
    });
    auto* remove =
        add(new QPushButton(Words::tr("Remove")), "remove", Words::tr("Remove this bound"));
    remove->setAutoDefault(false);
    connect(remove, &QPushButton::clicked, this, [this, index] {
        bounds_.erase(bounds_.begin() + static_cast<std::ptrdiff_t>(index));
        fill();
        changed_("", bounds_);
    });
    return row;
}

}  // namespace hepatica
