// SPDX-License-Identifier: GPL-3.0-or-later
// Lesson editor page for the rules of the whole lesson: limits, of which the first one broken ends
// the attempt, and pass marks, which are checked at the end.
#pragma once

#include "ui/lesson_editor/lesson_page.h"

namespace hepatica {

class BoundsTable;

class RulesPage : public LessonPage {
  public:
    explicit RulesPage(Changes changes);

  protected:
    void fill(const Lesson& lesson) override;

  private:
    BoundsTable* limits_;
    BoundsTable* pass_;
};

}  // namespace hepatica
