// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/quality_panel.h"

#include <QCheckBox>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <cmath>
#include <utility>

#include "core/base/units.h"
#include "core/scene/scene_spec.h"

namespace hepatica {
namespace {

// What scenes begin with: see DeformSpec.
const double tissue_pa_per_mm2 = DeformSpec{}.tether_pa_per_mm2;

}  // namespace

QString percent_text(double share) {
    const double percent = 100.0 * share;
    const int decimals = percent >= 10.0 ? 0 : percent >= 1.0 ? 1 : 2;
    return QString::number(percent, 'f', decimals) + " %";
}

QualityPanel::QualityPanel(std::function<void(Command)> post, QWidget* parent)
    : QWidget(parent),
      post_(std::move(post)),
      automatic_(new QCheckBox("Automatic: as accurate as this computer can", this)),
      dial_(new QSlider(Qt::Horizontal, this)),
      error_(new QLabel(this)),
      solver_(new QLabel(this)),
      gravity_(new QCheckBox("Gravity (patient on the back)", this)),
      tether_(new QCheckBox("Tissue holds the vessels", this)) {
    auto* column = new QVBoxLayout(this);
    auto* dial_box = new QGroupBox("Speed or accuracy", this);
    auto* dial_column = new QVBoxLayout(dial_box);
    automatic_->setObjectName("automatic");
    automatic_->setChecked(true);
    automatic_->setToolTip(
        "Picks the most accurate setting whose frames are in time; moving the dial ends it");
    connect(automatic_, &QCheckBox::clicked, this, [this](bool on) {
        post_(on ? Command(SetAutomaticQuality{true})
                 : Command(SetQuality{dial_->value() / 100.0}));
    });
    dial_column->addWidget(automatic_);
    auto* ends = new QHBoxLayout;
    ends->addWidget(new QLabel("fastest", dial_box));
    ends->addWidget(new QLabel("most accurate", dial_box), 0, Qt::AlignRight);
    dial_->setRange(0, 100);
    dial_->setValue(50);
    dial_->setAccessibleName("Speed or accuracy");
    connect(dial_, &QSlider::valueChanged, this, [this](int value) {
        automatic_->setChecked(false);
        post_(SetQuality{value / 100.0});
    });
    dial_column->addWidget(dial_);
    dial_column->addLayout(ends);
    error_->setWordWrap(true);
    solver_->setObjectName("quiet");
    solver_->setWordWrap(true);
    dial_column->addWidget(error_);
    dial_column->addWidget(solver_);
    column->addWidget(dial_box);

    auto* body_box = new QGroupBox("What acts on the vessels", this);
    auto* body_column = new QVBoxLayout(body_box);
    connect(gravity_, &QCheckBox::toggled, this,
            [this](bool on) { post_(SetGravity{Vec3(0, on ? units::standard_gravity : 0.0, 0)}); });
    tether_->setChecked(true);
    connect(tether_, &QCheckBox::toggled, this,
            [this](bool on) { post_(SetTether{on ? tissue_pa_per_mm2 : 0.0}); });
    body_column->addWidget(gravity_);
    body_column->addWidget(tether_);
    column->addWidget(body_box);
    column->addStretch(1);
    show_statistics({});
}

void QualityPanel::post_choices() {
    if (!automatic_->isChecked()) post_(SetQuality{dial_->value() / 100.0});
    if (gravity_->isChecked()) post_(SetGravity{Vec3(0, units::standard_gravity, 0)});
    if (!tether_->isChecked()) post_(SetTether{0.0});
}

void QualityPanel::show_statistics(const FrameStatistics& statistics) {
    if (statistics.expected_error > 0.0) {
        const QString against = QString::fromStdString(statistics.error_reference);
        error_->setText("Expected error " + percent_text(statistics.expected_error) +
                        (against.isEmpty() ? QString() : " against " + against));
    } else {
        error_->setText("Expected error: not measured for this scene");
    }
    const bool begun = !statistics.setting.empty();
    if (begun && !dial_->isSliderDown()) {
        automatic_->setChecked(statistics.automatic);
        if (statistics.automatic) {
            const QSignalBlocker silent(dial_);
            dial_->setValue(static_cast<int>(std::lround(100.0 * statistics.quality)));
        }
    }
    solver_->setText(statistics.setting.empty()
                         ? QString()
                         : QString("%1; %2 iterations a step%3")
                               .arg(QString::fromStdString(statistics.setting))
                               .arg(statistics.linear_iterations)
                               .arg(statistics.degraded ? ", degraded" : ""));
}

}  // namespace hepatica
