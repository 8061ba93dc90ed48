// SPDX-License-Identifier: GPL-3.0-or-later
// The places of a lesson: marks that goals speak of, and where the drug's target begins. Each is a
// share of the longest path, which every patient has, or a point on the vessels that is clicked on.
#pragma once

#include "ui/lesson_editor/lesson_page.h"

class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace hepatica {

class PlacesPage : public LessonPage {
  public:
    // `ask_for_place`: the next click on a vessel is told to place_clicked(). `ask_no_more`: not
    // after all.
    PlacesPage(Changes changes, std::function<void()> ask_for_place,
               std::function<void()> ask_no_more);

    // On the centreline, undeformed. Nothing where no place was asked for.
    void place_clicked(const Vec3& place_mm);
    bool waits() const { return waits_for_ != nobody; }
    void wait_no_more();

  protected:
    void fill(const Lesson& lesson) override;

  private:
    static constexpr int nobody = -2, target = -1;  // else a mark's number

    QWidget* make_row(int place, const std::string& name, const ScriptPlace& at);
    void ask(int place);
    void rename(int mark, QLineEdit& field);
    void set_place(int place, const ScriptPlace& at, bool same_row);
    void remove(int place);

    std::function<void()> ask_for_place_, ask_no_more_;
    int waits_for_ = nobody;
    std::vector<std::string> names_;  // of the marks
    QVBoxLayout* marks_;
    QVBoxLayout* target_;
    QPushButton* add_target_;
};

}  // namespace hepatica
