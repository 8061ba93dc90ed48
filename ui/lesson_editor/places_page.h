// SPDX-License-Identifier: GPL-3.0-or-later
// Lesson editor page for places: the marks that goals refer to, and where the drug's target begins.
// A place is a share of the longest path, which every patient has, or a point on the shown vessels.
#pragma once

#include "ui/lesson_editor/lesson_page.h"

class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace hepatica {

// A tumour of the shown patient and where the vessels that lead to it begin, mm.
struct TumourPlace {
    int number = 0;
    double volume_ml = 0.0;
    Vec3 from_mm = Vec3::Zero();
    double aside_mm = 0.0;  // from its middle to there
};

class PlacesPage : public LessonPage {
  public:
    // `ask_for_place`: send the next click on a vessel to place_clicked(). `ask_no_more`: cancel
    // that. `tumours`: those that can be the target. `is_hidden`: whether a place cannot be seen in
    // the view.
    PlacesPage(Changes changes, std::function<void()> ask_for_place,
               std::function<void()> ask_no_more, std::function<std::vector<TumourPlace>()> tumours,
               std::function<bool(const ScriptPlace&)> is_hidden);

    // On the centreline of the undeformed vessels, mm; rounded to 0.1 mm. No effect if no place is
    // waited for.
    void place_clicked(const Vec3& place_mm);
    bool waits() const { return waits_for_ != nobody; }
    // Cancels waiting for a click; calls ask_no_more if it was waiting.
    void wait_no_more();
    // The tumours have changed.
    void offer_tumours();

  protected:
    void fill(const Lesson& lesson) override;

  private:
    static constexpr int nobody = -2, target = -1;  // otherwise the index of a mark

    QWidget* make_row(int place, const std::string& name, const ScriptPlace& at);
    void add_mark();
    void ask(int place);
    void rename(int mark, QLineEdit& field);
    void set_place(int place, const ScriptPlace& at, bool same_row);
    void remove(int place);

    std::function<void()> ask_for_place_, ask_no_more_;
    std::function<std::vector<TumourPlace>()> tumours_;
    std::function<bool(const ScriptPlace&)> is_hidden_;
    int waits_for_ = nobody;
    std::vector<std::string> names_;  // of the marks
    QVBoxLayout* marks_;
    QVBoxLayout* target_;
    QPushButton *add_target_, *tumour_;
};

}  // namespace hepatica
