// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/volume_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <cmath>
#include <utility>

#include "ui/words.h"

namespace hepatica {

VolumeBar::VolumeBar(const VolumeLook& look,
                     std::function<void(VolumePreset, double density)> choose, QWidget* parent)
    : QWidget(parent), preset_(new QComboBox), density_(new QSlider(Qt::Horizontal)) {
    setObjectName("volumeBar");
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
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 4, 8, 4);
    row->addWidget(new QLabel(Words::tr("CT as volume")));
    row->addWidget(preset_);
    row->addSpacing(8);
    row->addWidget(new QLabel(Words::tr("Density")));
    row->addWidget(density_);
    row->addStretch(1);
    const auto tell = [this, choose = std::move(choose)] {
        choose(static_cast<VolumePreset>(preset_->currentIndex()), 0.01 * density_->value());
    };
    connect(preset_, &QComboBox::activated, this, tell);
    connect(density_, &QSlider::valueChanged, this, tell);
}

}  // namespace hepatica
