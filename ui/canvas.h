// SPDX-License-Identifier: GPL-3.0-or-later
// What the three-dimensional view draws on, and how its pictures reach the screen: a surface of
// OpenGL where there is a graphics card, an image where the processor draws.
#pragma once

#include <QImage>
#include <QOpenGLContext>
#include <QWidget>
#include <functional>

namespace hepatica {

// What a canvas asks of whoever draws on it. The context is current in every call but `shown`.
struct CanvasPainter {
    std::function<void(QOpenGLContext& context)> begin;  // before the first picture of a context
    // Draws a picture of `pixels`; returns the framebuffer in which it lies.
    std::function<unsigned(const QSize& pixels)> draw;
    std::function<void()> shown;  // a picture that was drawn for the screen has reached it
    std::function<void()> end;    // the context is about to go
};

class Canvas {
  public:
    virtual ~Canvas() = default;

    virtual QWidget& widget() = 0;
    // A picture is drawn as soon as the event loop comes to it.
    virtual void redraw() = 0;
    // Draws a picture now, not for the screen, and reads it; at the screen's own resolution.
    virtual QImage drawn() = 0;
    // Before the painter's own members go.
    virtual void finish() = 0;
};

// The canvas becomes a child of `view`, which owns it, fills it and gets its mouse. Where no
// context can be made the surface is left to say so.
Canvas* make_canvas(QWidget& view, CanvasPainter painter);

}  // namespace hepatica
