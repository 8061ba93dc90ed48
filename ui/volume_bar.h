// SPDX-License-Identifier: GPL-3.0-or-later
// Bar above the view while the CT is drawn as a volume: preset and density. UI thread only.
#pragma once

#include <QWidget>
#include <functional>

#include "render/volume_look.h"

class QComboBox;
class QSlider;

namespace hepatica {

class VolumeBar : public QWidget {
  public:
    // Uses preset and density of `look`.
    VolumeBar(const VolumeLook& look, std::function<void(VolumePreset, double density)> choose,
              QWidget* parent = nullptr);

  private:
    QComboBox* preset_;
    QSlider* density_;
};

}  // namespace hepatica
