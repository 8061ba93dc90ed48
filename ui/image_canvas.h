// SPDX-License-Identifier: GPL-3.0-or-later
// Canvas for software rendering: the picture is read from its framebuffer, which is in main memory
// anyway, and painted like any other widget. With a QOpenGLWidget Qt would compose the whole window
// from textures for every picture, which takes as long as the picture itself.
#pragma once

#include <memory>

#include "ui/canvas.h"
#include "ui/hidden_context.h"

namespace hepatica {

// UI thread only.
class ImageCanvas : public QWidget, public Canvas {
  public:
    ImageCanvas(QWidget& view, std::unique_ptr<HiddenContext> context, CanvasPainter painter);
    ~ImageCanvas() override;

    QWidget& widget() override { return *this; }
    void redraw() override;
    QImage drawn() override;
    void finish() override;
    void make_current() override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void draw();

    std::unique_ptr<HiddenContext> context_;
    CanvasPainter painter_;
    QImage image_;       // the last picture
    bool stale_ = true;  // another picture was requested since
    bool begun_ = false;
};

}  // namespace hepatica
