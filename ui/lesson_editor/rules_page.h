// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for the whole lesson: the limits, of which the first that is broken ends the attempt,
// and the marks that are to be reached in the end.
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
