// SPDX-License-Identifier: GPL-3.0-or-later
// Over the three-dimensional view while it has the keyboard: a frame, as slices have one, and where
// keys are used the aim that they act at. The mouse passes through it.
#pragma once

#include <QWidget>
#include <optional>

namespace hepatica {

class ViewFocus : public QWidget {
  public:
    // Covers all of it; hidden at first.
    explicit ViewFocus(QWidget& view);

    // The aim in points; none: the mouse is used. `holds`: something is led by it.
    void show_aim(const std::optional<QPointF>& aim, bool holds);
    const std::optional<QPointF>& aim() const { return aim_; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    std::optional<QPointF> aim_;
    bool holds_ = false;
};

}  // namespace hepatica
