// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/surface_canvas.h"

#include <QOpenGLExtraFunctions>
#include <utility>

#include "ui/pixel_mapping.h"

namespace hepatica {

SurfaceCanvas::SurfaceCanvas(QWidget& view, CanvasPainter painter)
    : QOpenGLWidget(&view), painter_(std::move(painter)) {
    // Qt also swaps the window when only another widget was painted.
    connect(this, &QOpenGLWidget::frameSwapped, this, [this] {
        if (std::exchange(awaits_swap_, false)) painter_.shown();
    });
}

SurfaceCanvas::~SurfaceCanvas() {
    finish();
}

// The base class destroys the context after the members of this class, when the slot connected in
// initializeGL() must no longer run.
void SurfaceCanvas::finish() {
    if (!context()) return;
    if (disconnect(context(), nullptr, this, nullptr)) end();
}

void SurfaceCanvas::make_current() {
    if (context() && QOpenGLContext::currentContext() != context()) makeCurrent();
}

void SurfaceCanvas::end() {
    makeCurrent();
    painter_.end();
    doneCurrent();
}

QImage SurfaceCanvas::drawn() {
    for_screen_ = false;
    QImage image = grabFramebuffer();
    for_screen_ = true;
    return image;
}

void SurfaceCanvas::initializeGL() {
    // Qt makes a new context when the widget moves to another window.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { end(); });
    painter_.begin(*context());
}

void SurfaceCanvas::paintGL() {
    const QSize size = pixel_size(this->size(), devicePixelRatioF());
    const unsigned source = painter_.draw(size);
    QOpenGLExtraFunctions& gl = *context()->extraFunctions();
    gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, source);
    gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
    const GLenum attachment = GL_COLOR_ATTACHMENT0;
    gl.glDrawBuffers(1, &attachment);
    gl.glReadBuffer(GL_COLOR_ATTACHMENT0);
    gl.glDisable(GL_SCISSOR_TEST);
    gl.glBlitFramebuffer(0, 0, size.width(), size.height(), 0, 0, size.width(), size.height(),
                         GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl.glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
    // One that is only read does not take the place of one that is on its way to the screen.
    awaits_swap_ = awaits_swap_ || for_screen_;
}

}  // namespace hepatica
