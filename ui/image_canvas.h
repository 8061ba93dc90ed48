// SPDX-License-Identifier: GPL-3.0-or-later
// Where the processor draws: the picture is read from its framebuffer, which lies in memory anyway,
// and painted like any other widget. A QOpenGLWidget would make Qt compose the whole window out of
// textures for every picture, which takes the processor as long as the picture itself.
#pragma once

#include <memory>

#include "ui/canvas.h"
#include "ui/hidden_context.h"

namespace hepatica {

class ImageCanvas : public QWidget, public Canvas {
  public:
    ImageCanvas(QWidget& view, std::unique_ptr<HiddenContext> context, CanvasPainter painter);
    ~ImageCanvas() override;

    QWidget& widget() override { return *this; }
    void redraw() override;
    QImage drawn() override;
    void finish() override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void draw();

    std::unique_ptr<HiddenContext> context_;
    CanvasPainter painter_;
    QImage image_;       // what was drawn last
    bool stale_ = true;  // another picture was asked for since
    bool begun_ = false;
};

}  // namespace hepatica
