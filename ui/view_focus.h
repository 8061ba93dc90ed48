// SPDX-License-Identifier: GPL-3.0-or-later
// Overlay of the 3D view while it has the keyboard focus: a frame, and the aim at which keys act.
// Mouse events pass through. UI thread only.
#pragma once

#include <QWidget>
#include <optional>

namespace hepatica {

class ViewFocus : public QWidget {
  public:
    // Covers the whole view; hidden at first.
    explicit ViewFocus(QWidget& view);

    // Aim in points; nullopt: the mouse is used. `holds`: the aim moves something.
    void show_aim(const std::optional<QPointF>& aim, bool holds);
    const std::optional<QPointF>& aim() const { return aim_; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    std::optional<QPointF> aim_;
    bool holds_ = false;
};

}  // namespace hepatica
