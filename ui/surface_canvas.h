// SPDX-License-Identifier: GPL-3.0-or-later
// Where a graphics card draws: a surface of OpenGL that Qt composes with the rest of the window.
#pragma once

#include <QOpenGLWidget>

#include "ui/canvas.h"

namespace hepatica {

class SurfaceCanvas : public QOpenGLWidget, public Canvas {
  public:
    SurfaceCanvas(QWidget& view, CanvasPainter painter);
    ~SurfaceCanvas() override;

    QWidget& widget() override { return *this; }
    void redraw() override { update(); }
    QImage drawn() override;
    void finish() override;

  protected:
    void initializeGL() override;
    void paintGL() override;

  private:
    void end();

    CanvasPainter painter_;
    bool for_screen_ = true;  // else it is only read
    bool awaits_swap_ = false;
};

}  // namespace hepatica
