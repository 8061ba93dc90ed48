// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/image_canvas.h"

#include <QOpenGLExtraFunctions>
#include <QPainter>
#include <utility>

#include "ui/pixel_mapping.h"

namespace hepatica {

ImageCanvas::ImageCanvas(QWidget& view, std::unique_ptr<HiddenContext> context,
                         CanvasPainter painter)
    : QWidget(&view), context_(std::move(context)), painter_(std::move(painter)) {
    setAttribute(Qt::WA_OpaquePaintEvent);
}

ImageCanvas::~ImageCanvas() {
    finish();
}

void ImageCanvas::finish() {
    if (!std::exchange(begun_, false) || !context_->make_current()) return;
    painter_.end();
    context_->context().doneCurrent();
}

void ImageCanvas::make_current() {
    if (begun_ && QOpenGLContext::currentContext() != &context_->context())
        context_->make_current();
}

void ImageCanvas::redraw() {
    stale_ = true;
    update();
}

QImage ImageCanvas::drawn() {
    draw();
    return image_;
}

// A part that was merely covered needs no new picture.
void ImageCanvas::paintEvent(QPaintEvent* /*event*/) {
    if (stale_ || image_.size() != pixel_size(size(), devicePixelRatioF())) {
        stale_ = false;
        draw();
        // The widget's window reaches the screen after all of it has been painted.
        QMetaObject::invokeMethod(this, painter_.shown, Qt::QueuedConnection);
    }
    QPainter(this).drawImage(QPointF(), image_);
}

void ImageCanvas::draw() {
    if (!context_->make_current()) return;
    if (!std::exchange(begun_, true)) painter_.begin(context_->context());
    const QSize pixels = pixel_size(size(), devicePixelRatioF());
    const unsigned source = painter_.draw(pixels);
    if (image_.size() != pixels) image_ = QImage(pixels, QImage::Format_RGB32);
    image_.setDevicePixelRatio(devicePixelRatioF());
    QOpenGLExtraFunctions& gl = *context_->context().extraFunctions();
    gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, source);
    gl.glReadBuffer(GL_COLOR_ATTACHMENT0);
    gl.glReadPixels(0, 0, pixels.width(), pixels.height(), GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV,
                    image_.bits());
    image_.mirror();  // OpenGL's rows begin at the bottom
}

}  // namespace hepatica
