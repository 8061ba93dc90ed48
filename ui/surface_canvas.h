// SPDX-License-Identifier: GPL-3.0-or-later
// Canvas for a graphics card: an OpenGL surface that Qt composes with the rest of the window.
#pragma once

#include <QOpenGLWidget>

#include "ui/canvas.h"

namespace hepatica {

// UI thread only.
class SurfaceCanvas : public QOpenGLWidget, public Canvas {
  public:
    SurfaceCanvas(QWidget& view, CanvasPainter painter);
    ~SurfaceCanvas() override;

    QWidget& widget() override { return *this; }
    void redraw() override { update(); }
    QImage drawn() override;
    void finish() override;
    void make_current() override;

  protected:
    void initializeGL() override;
    void paintGL() override;

  private:
    void end();

    CanvasPainter painter_;
    bool for_screen_ = true;  // otherwise the picture is only read
    bool awaits_swap_ = false;
};

}  // namespace hepatica
