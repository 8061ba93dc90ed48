// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing surface of the 3D view and its way to the screen: an OpenGL surface with a graphics card,
// an image where the processor renders.
#pragma once

#include <QImage>
#include <QOpenGLContext>
#include <QWidget>
#include <functional>

namespace hepatica {

// Callbacks that draw on a canvas. The context is current in all of them except `shown`.
struct CanvasPainter {
    std::function<void(QOpenGLContext& context)> begin;  // before the first picture of a context
    // Draws a picture of this size; returns the framebuffer that holds it.
    std::function<unsigned(const QSize& pixels)> draw;
    std::function<void()> shown;  // a picture drawn for the screen has been shown
    std::function<void()> end;    // the context is about to be destroyed
};

// UI thread only.
class Canvas {
  public:
    virtual ~Canvas() = default;

    virtual QWidget& widget() = 0;
    // Schedules a new picture for the event loop.
    virtual void redraw() = 0;
    // Draws a picture now, not for the screen, and reads it at the screen's resolution.
    virtual QImage drawn() = 0;
    // To be called before the painter's members are destroyed.
    virtual void finish() = 0;
    // Makes the context of the pictures current, where there is one, for who frees what it drew
    // outside of the painter's callbacks: another context's objects have the same names.
    virtual void make_current() = 0;
};

// Makes the canvas as a child of `view`, which owns and fills it; mouse events go to `view`. If no
// OpenGL context can be made, the surface canvas reports that.
Canvas* make_canvas(QWidget& view, CanvasPainter painter);

}  // namespace hepatica
