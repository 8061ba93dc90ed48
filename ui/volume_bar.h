// SPDX-License-Identifier: GPL-3.0-or-later
// Bar above the view while the CT is drawn as a volume: preset and density, and what is being read
// for it, with Cancel. UI thread only.
#pragma once

#include <QWidget>
#include <functional>

#include "render/volume_look.h"

class QComboBox;
class QLabel;
class QPushButton;
class QSlider;

namespace hepatica {

class VolumeBar : public QWidget {
  public:
    struct Callbacks {
        std::function<void(VolumePreset, double density)> choose;
        std::function<void()> cancel;  // the reading
    };
    // Uses preset and density of `look`.
    VolumeBar(const VolumeLook& look, Callbacks callbacks, QWidget* parent = nullptr);

    // `stage`: what is being done.
    void show_reading(const QString& stage);
    // Nothing is read any more; whether there is a volume.
    void show_read(bool there);

  private:
    QWidget* controls_;
    QLabel* stage_;
    QPushButton* cancel_;
    QComboBox* preset_;
    QSlider* density_;
};

}  // namespace hepatica
