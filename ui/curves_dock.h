// SPDX-License-Identifier: GPL-3.0-or-later
// Dock with the curves of the last injection, computed in the background, and of the tear so far.
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

// UI thread only.
class CurvesDock : public QDockWidget {
  public:
    // `failed`: the curves of an injection cannot be computed.
    CurvesDock(std::function<void(const Failure&)> failed, QWidget* parent);

    PlotPanel& plots() { return *plots_; }
    // Computes the curves of the frame's injection if it is a new one, giving up those of an older
    // one, and shows them if they `may_come`.
    void follow(std::shared_ptr<const PatientCase> patient, const DrugView& drug,
                bool may_come = true);
    // Adds the newest frame's tear. The dock does not come for it: a tear comes unasked, and would
    // take room from the view while it is watched. Of a lesson none is shown: entropy is none of
    // its quantities.
    void follow_tear(const Frame& frame, bool of_lesson = false);
    // What was followed of the tears, and to go on from there.
    const TearHistory& tears() const { return tear_; }
    void show_tears(TearHistory tears);
    // Appears once no mouse button is down, unless the user closed it.
    void come();
    // Time on the drug's clock; nullopt: nothing is injected.
    void set_time(std::optional<double> time_s);
    // Forgets everything and stops computing. A dock that appeared by itself is hidden.
    void clear();

    // Whether it appears by itself when there is something to show; no longer once the user has
    // closed it, until he asks for it again.
    void set_comes_by_itself(bool comes) {
        comes_by_itself_ = comes;
        coming_ = coming_ && comes;
    }
    // Called when the user closes the dock.
    std::function<void(bool comes)> on_choice = [](bool) {};
    std::function<bool()> hand_drags;  // whether a mouse button is down; can be replaced in tests

  protected:
    void closeEvent(QCloseEvent* event) override;

  private:
    void come_when_nothing_is_held();
    void plot_tears();

    std::function<void(const Failure&)> failed_;
    PlotPanel* plots_;
    // Injection whose curves were requested last.
    std::shared_ptr<const InjectionOptions> followed_;
    int injections_ = 0;    // DrugView::injections of that
    bool another_ = false;  // it has replaced one before it
    std::unique_ptr<BackgroundJob> job_;
    TearHistory tear_;
    bool comes_by_itself_ = true;
    bool came_ = false;    // it appeared by itself and is still shown
    bool coming_ = false;  // it will appear once no mouse button is down
};

}  // namespace hepatica
