// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/curves_dock.h"

#include <utility>

#include "ui/plot_panel.h"
#include "ui/vessel_flow.h"

namespace hepatica {

CurvesDock::CurvesDock(std::function<void(const Failure&)> failed, QWidget* parent)
    : QDockWidget("Curves", parent), failed_(std::move(failed)), plots_(new PlotPanel) {
    setObjectName("Curves");
    setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
    setWidget(plots_);
}

void CurvesDock::show_injection(std::shared_ptr<const PatientCase> patient, const TreePoint& tip,
                                const InjectDrug& injection) {
    if (tip.segment < 0) return;
    BackgroundJob::Callbacks callbacks;
    callbacks.progress = [](const JobProgress&) {};
    callbacks.failed = failed_;
    callbacks.cancelled = [] {};
    callbacks.ended = [this] { job_.reset(); };
    job_ = std::make_unique<BackgroundJob>(
        [this, tip, injection, patient = std::move(patient)](Job& job) -> std::function<void()> {
            const auto curves = injection_curves(patient->tree, tip, injection, job);
            return [this, curves] {
                plots_->set_charts(curves.pressure, curves.delivery);
                show();
            };
        },
        std::move(callbacks));
}

void CurvesDock::set_time(std::optional<double> time_s) {
    plots_->set_time(time_s);
}

void CurvesDock::clear() {
    job_.reset();
    plots_->clear();
}

}  // namespace hepatica
