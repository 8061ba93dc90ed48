// SPDX-License-Identifier: GPL-3.0-or-later
// The curves of the last injection, computed beside the play, and of the tear so far, in a dock of
// their own.
#pragma once

#include <QDockWidget>
#include <functional>
#include <memory>
#include <optional>

#include "core/patient/patient_case.h"
#include "core/scene/frame.h"
#include "ui/background_job.h"
#include "ui/tear_history.h"

namespace hepatica {

class PlotPanel;

class CurvesDock : public QDockWidget {
  public:
    // `failed`: of an injection whose curves cannot be computed.
    CurvesDock(std::function<void(const Failure&)> failed, QWidget* parent);

    PlotPanel& plots() { return *plots_; }
    // Follows the newest frame: computes the curves of an injection that it has not seen yet and
    // then shows them, where they `may_come`. What was being computed for an older one is given up.
    void follow(std::shared_ptr<const PatientCase> patient, const DrugView& drug,
                bool may_come = true);
    // Takes over the newest frame's tear, and where it `may_come` shows itself as soon as something
    // is torn.
    void follow_tear(const Frame& frame, bool may_come = true);
    // The drug's clock in the curves; none: nothing is injected.
    void set_time(std::optional<double> time_s);
    // Forgets all; nothing is computed any more. Where it came by itself it goes, too: nothing is
    // left to show.
    void clear();

    // Whether it comes by itself when there is something to show: until the user closes it, and
    // again from when it is asked for.
    bool comes_by_itself() const { return comes_by_itself_; }
    void set_comes_by_itself(bool comes) { comes_by_itself_ = comes; }
    std::function<void(bool comes)> on_choice = [](bool) {};  // the user closed it
    std::function<bool()> hand_drags;  // whether a button of the mouse is down; the program's own

  protected:
    void closeEvent(QCloseEvent* event) override;

  private:
    void come();
    void come_when_nothing_is_held();

    std::function<void(const Failure&)> failed_;
    PlotPanel* plots_;
    std::shared_ptr<const InjectionOptions> followed_;  // whose curves were asked for last
    std::unique_ptr<BackgroundJob> job_;
    TearHistory tear_;
    bool comes_by_itself_ = true;
    bool came_ = false;    // by itself, and is there since
    bool coming_ = false;  // as soon as no button of the mouse is down
};

}  // namespace hepatica
