// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/curves_dock.h"

#include <QCloseEvent>
#include <QGuiApplication>
#include <utility>

#include "ui/core_words.h"
#include "ui/plot_panel.h"
#include "ui/vessel_flow.h"
#include "ui/words.h"

namespace hepatica {

CurvesDock::CurvesDock(std::function<void(const Failure&)> failed, QWidget* parent)
    : QDockWidget(Words::tr("Curves"), parent),
      hand_drags([] { return QGuiApplication::mouseButtons() != Qt::NoButton; }),
      failed_(std::move(failed)),
      plots_(new PlotPanel) {
    setObjectName("Curves");
    setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
    setWidget(plots_);
}

void CurvesDock::follow(std::shared_ptr<const PatientCase> patient, const DrugView& drug,
                        bool may_come) {
    // It was removed.
    if (!drug.injection && std::exchange(followed_, nullptr)) {
        job_.reset();
        coming_ = false;
        plots_->clear_injection();
    }
    if (!drug.injection || drug.injection == followed_) return;
    // The same one is computed again where vessels tear.
    const bool had_one = std::exchange(followed_, drug.injection) != nullptr;
    if (std::exchange(injections_, drug.injections) != drug.injections || !had_one)
        another_ = had_one;
    BackgroundJob::Callbacks callbacks;
    callbacks.failed = failed_;
    callbacks.ended = [this] { job_.reset(); };
    job_ = std::make_unique<BackgroundJob>(
        [this, injection = drug.injection, end_s = drug.end_s, may_come, another = another_,
         patient = std::move(patient)](Job& job) -> std::function<void()> {
            InjectionCurves curves = injection_curves(patient->tree, *injection, end_s, job);
            // It has replaced those before it.
            if (another)
                curves.pressure.x_label = curves.delivery.x_label =
                    Words::id("Time since the last injection began (s)");
            return [this, curves = std::move(curves), may_come] {
                plots_->set_charts(curves.pressure, curves.delivery);
                if (may_come) come();
            };
        },
        std::move(callbacks));
}

void CurvesDock::follow_tear(const Frame& frame, bool of_lesson) {
    const bool changed = of_lesson ? !tear_.empty() : tear_.follow(frame);
    if (of_lesson) tear_.clear();
    if (changed) plot_tears();
}

void CurvesDock::show_tears(TearHistory tears) {
    tear_ = std::move(tears);
    plot_tears();
}

void CurvesDock::plot_tears() {
    if (tear_.empty()) return plots_->set_tear({}, {});
    std::vector<PlotEvent> events;
    for (const TearHistory::Event& event : tear_.events())
        events.push_back({event.time_s, translated(event.text)});
    plots_->set_tear(tear_.chart(), std::move(events));
}

void CurvesDock::come() {
    if (!comes_by_itself_ || !isHidden()) return;
    coming_ = true;
    come_when_nothing_is_held();
}

// Showing the dock shrinks the view, which would displace what is being dragged.
void CurvesDock::come_when_nothing_is_held() {
    if (!coming_ || hand_drags()) return;
    coming_ = false;
    came_ = true;
    show();
}

void CurvesDock::set_time(std::optional<double> time_s) {
    come_when_nothing_is_held();
    plots_->set_time(time_s);
}

void CurvesDock::clear() {
    job_.reset();
    followed_.reset();
    tear_.clear();
    plots_->clear();
    coming_ = false;
    if (std::exchange(came_, false)) hide();
}

void CurvesDock::closeEvent(QCloseEvent* event) {
    QDockWidget::closeEvent(event);
    comes_by_itself_ = came_ = false;
    on_choice(false);
}

}  // namespace hepatica
