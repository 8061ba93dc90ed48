// SPDX-License-Identifier: GPL-3.0-or-later
// Above the view while the CT is drawn as a volume: what of it stands out, and how dense it is.
#pragma once

#include <QWidget>
#include <functional>

#include "render/volume_look.h"

class QComboBox;
class QSlider;

namespace hepatica {

class VolumeBar : public QWidget {
  public:
    // Of the look, the bar knows preset and density.
    VolumeBar(const VolumeLook& look, std::function<void(VolumePreset, double density)> choose,
              QWidget* parent = nullptr);

  private:
    QComboBox* preset_;
    QSlider* density_;
};

}  // namespace hepatica
