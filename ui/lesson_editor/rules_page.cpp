// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_editor/rules_page.h"

#include <QVBoxLayout>
#include <utility>

#include "ui/lesson_editor/bounds_table.h"
#include "ui/words.h"

namespace hepatica {

RulesPage::RulesPage(Changes changes)
    : LessonPage(std::move(changes)),
      limits_(
          new BoundsTable(Words::tr("Limits all the time: the first one broken ends the attempt"),
                          "limit", {Quantity::force_mn, -1, false, 500.0},
                          [this](const std::string& row, const std::vector<Predicate>& bounds) {
                              change_value(row.empty() ? "" : "limits" + row,
                                           [&](Lesson& lesson) { lesson.limits = bounds; });
                          })),
      pass_(new BoundsTable(Words::tr("Pass marks: looked at in the end alone"), "pass",
                            {Quantity::time_s, -1, false, 60.0},
                            [this](const std::string& row, const std::vector<Predicate>& bounds) {
                                change_value(row.empty() ? "" : "pass" + row,
                                             [&](Lesson& lesson) { lesson.pass = bounds; });
                            })) {
    auto* column = new QVBoxLayout(this);
    column->addWidget(limits_);
    column->addSpacing(12);
    column->addWidget(pass_);
    column->addStretch(1);
}

void RulesPage::fill(const Lesson& lesson) {
    limits_->show_bounds(lesson.limits, lesson.mark_names());
    pass_->show_bounds(lesson.pass, lesson.mark_names());
}

}  // namespace hepatica
