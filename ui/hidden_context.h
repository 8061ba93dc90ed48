// SPDX-License-Identifier: GPL-3.0-or-later
// A context of OpenGL that draws on nothing that is seen: to ask what draws here, and to draw into
// framebuffers of one's own.
#pragma once

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <string>

namespace hepatica {

class HiddenContext {
  public:
    HiddenContext();

    QOpenGLContext& context() { return context_; }
    // False where OpenGL cannot draw on this display.
    bool make_current();
    // What the driver calls itself. The context is current.
    std::string renderer_name();

  private:
    QOffscreenSurface surface_;  // outlives the context
    QOpenGLContext context_;
};

}  // namespace hepatica
