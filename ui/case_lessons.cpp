// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/case_lessons.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <optional>
#include <utility>

#include "ui/core_words.h"
#include "ui/plain_text.h"
#include "ui/words.h"

namespace hepatica {
namespace {

using Patient = ShelvedLesson::Patient;

QString title_of(Patient patient) {
    switch (patient) {
        case Patient::this_case:
            return Words::tr("For this patient");
        case Patient::any:
            return Words::tr("For any patient");
        case Patient::unreadable:
            break;
    }
    return Words::tr("Cannot be read");
}

QString misfits_in_words(const std::vector<std::string>& misfits) {
    QStringList lines{Words::tr("The vessels were corrected since this lesson was made.")};
    for (const std::string& misfit : misfits) lines << translated(misfit);
    return lines.join(" ");
}

}  // namespace

CaseLessons::CaseLessons(Begin begin, QWidget* parent)
    : QWidget(parent),
      begin_(std::move(begin)),
      list_(new QTreeWidget),
      start_(new QPushButton(Words::tr("&Begin the lesson"))) {
    list_->setObjectName("caseLessons");
    list_->setAccessibleName(Words::tr("Lessons that go with the case"));
    list_->setHeaderHidden(true);
    list_->setRootIsDecorated(false);
    list_->setItemsExpandable(false);
    list_->setIndentation(12);
    start_->setObjectName("caseLessonBegin");
    start_->setAutoDefault(false);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    auto* title = new QLabel(Words::tr("Lessons"));
    title->setBuddy(list_);
    column->addWidget(title);
    column->addWidget(list_, 1);
    column->addWidget(start_);
    connect(list_, &QTreeWidget::currentItemChanged, this, [this] { follow_choice(); });
    connect(list_, &QTreeWidget::itemActivated, this, [this] { begin_chosen(); });
    connect(start_, &QPushButton::clicked, this, [this] { begin_chosen(); });
    follow_choice();
}

void CaseLessons::show_lessons(std::vector<ShelvedLesson> lessons, bool can_begin) {
    lessons_ = std::move(lessons);
    can_begin_ = can_begin;
    list_->clear();
    QTreeWidgetItem* part = nullptr;
    std::optional<Patient> of;
    for (std::size_t i = 0; i < lessons_.size(); ++i) {
        const ShelvedLesson& lesson = lessons_[i];
        if (of != lesson.patient) {
            part = new QTreeWidgetItem(list_, {title_of(lesson.patient)});
            part->setFlags(Qt::ItemIsEnabled);
            QFont bold = list_->font();
            bold.setBold(true);
            part->setFont(0, bold);
            of = lesson.patient;
        }
        const bool fits = lesson.misfits.empty();
        auto* row = new QTreeWidgetItem(
            part, {fits ? lesson.name : Words::tr("⚠ %1 (no longer fits)").arg(lesson.name)});
        row->setToolTip(0, as_plain(fits ? lesson.about : misfits_in_words(lesson.misfits)));
        row->setData(0, Qt::UserRole, static_cast<int>(i));
    }
    if (lessons_.empty()) {
        auto* none =
            new QTreeWidgetItem(list_, {Words::tr("No lesson in this folder goes with it")});
        none->setFlags(Qt::NoItemFlags);
        none->setToolTip(0, Words::tr("Lesson > Edit lessons makes one; save it in this folder"));
    }
    list_->expandAll();
    follow_choice();
}

const ShelvedLesson* CaseLessons::chosen() const {
    const QTreeWidgetItem* row = list_->currentItem();
    if (row == nullptr || row->parent() == nullptr) return nullptr;
    return &lessons_[static_cast<std::size_t>(row->data(0, Qt::UserRole).toInt())];
}

void CaseLessons::follow_choice() {
    const ShelvedLesson* lesson = chosen();
    start_->setEnabled(can_begin_ && lesson && lesson->patient != Patient::unreadable);
}

void CaseLessons::begin_chosen() {
    if (!start_->isEnabled()) return;
    const ShelvedLesson lesson = *chosen();  // a copy, because begin_ may refill the list
    begin_(lesson);
}

}  // namespace hepatica
