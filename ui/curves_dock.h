// SPDX-License-Identifier: GPL-3.0-or-later
// The curves of the last injection, computed beside the play, in a dock of their own.
#pragma once

#include <QDockWidget>
#include <functional>
#include <memory>
#include <optional>

#include "core/patient/patient_case.h"
#include "core/session/command.h"
#include "ui/background_job.h"

namespace hepatica {

class PlotPanel;

class CurvesDock : public QDockWidget {
  public:
    // `failed`: of an injection whose curves cannot be computed.
    CurvesDock(std::function<void(const Failure&)> failed, QWidget* parent);

    PlotPanel& plots() { return *plots_; }
    // Computes the curves and then shows them; those that are being computed are given up.
    void show_injection(std::shared_ptr<const PatientCase> patient, const TreePoint& tip,
                        const InjectDrug& injection);
    // The drug's clock in the curves; none: nothing is injected.
    void set_time(std::optional<double> time_s);
    // Forgets all; nothing is computed any more.
    void clear();

  private:
    std::function<void(const Failure&)> failed_;
    PlotPanel* plots_;
    std::unique_ptr<BackgroundJob> job_;
};

}  // namespace hepatica
