// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/volume_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <cmath>
#include <utility>

#include "ui/words.h"

namespace hepatica {

VolumeBar::VolumeBar(const VolumeLook& look, Callbacks callbacks, QWidget* parent)
    : QWidget(parent),
      controls_(new QWidget),
      stage_(new QLabel),
      cancel_(new QPushButton(Words::tr("Cancel"))),
      preset_(new QComboBox),
      density_(new QSlider(Qt::Horizontal)) {
    controls_->setObjectName("volumeBar");
    // In the order of VolumePreset.
    preset_->addItems({Words::tr("Vessels and bones"), Words::tr("Maximum intensity")});
    preset_->setObjectName("volumePreset");
    preset_->setAccessibleName(Words::tr("What of the CT stands out"));
    preset_->setToolTip(
        Words::tr("Vessels and bones: light on what is bright, soft tissue a haze. "
                  "Maximum intensity: the brightest voxel behind each point. Both follow the grey "
                  "window of the slices: what they show black is clear"));
    preset_->setCurrentIndex(static_cast<int>(look.preset));
    density_->setObjectName("volumeDensity");
    density_->setAccessibleName(Words::tr("How dense the CT is drawn"));
    density_->setToolTip(Words::tr("How dense the CT is drawn"));
    density_->setRange(0, 100);
    density_->setValue(static_cast<int>(std::lround(100.0 * look.density)));
    density_->setFixedWidth(140);
    auto* row = new QHBoxLayout(controls_);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(new QLabel(Words::tr("CT as volume")));
    row->addWidget(preset_);
    row->addSpacing(8);
    row->addWidget(new QLabel(Words::tr("Density")));
    row->addWidget(density_);
    stage_->setObjectName("quiet");
    stage_->setTextFormat(Qt::PlainText);
    stage_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    stage_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // widens no window
    cancel_->setObjectName("cancelVolume");
    cancel_->setToolTip(Words::tr("Ends the reading of the CT as a volume, and hides it"));
    // So that the pictures below stay where they are when it goes.
    QSizePolicy keeps_its_place = cancel_->sizePolicy();
    keeps_its_place.setRetainSizeWhenHidden(true);
    cancel_->setSizePolicy(keeps_its_place);
    auto* all = new QHBoxLayout(this);
    all->setContentsMargins(8, 4, 8, 4);
    all->addWidget(controls_);
    all->addWidget(stage_, 1);
    all->addWidget(cancel_);
    show_read(false);
    const auto tell = [this, choose = std::move(callbacks.choose)] {
        choose(static_cast<VolumePreset>(preset_->currentIndex()), 0.01 * density_->value());
    };
    connect(preset_, &QComboBox::activated, this, tell);
    connect(density_, &QSlider::valueChanged, this, tell);
    connect(cancel_, &QPushButton::clicked, this, std::move(callbacks.cancel));
}

void VolumeBar::show_reading(const QString& stage) {
    stage_->setText(stage);
    cancel_->show();
}

void VolumeBar::show_read(bool there) {
    controls_->setEnabled(there);
    stage_->clear();
    cancel_->hide();
}

}  // namespace hepatica
