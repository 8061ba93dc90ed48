// SPDX-License-Identifier: GPL-3.0-or-later
// An OpenGL context without a visible surface: tells which renderer there is and draws into
// framebuffers.
#pragma once

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <string>

namespace hepatica {

class HiddenContext {
  public:
    // Creates context and surface; whether that succeeded is told by make_current().
    HiddenContext();

    QOpenGLContext& context() { return context_; }
    // False if OpenGL is not available on this display.
    bool make_current();
    // Name of the renderer. The context must be current.
    std::string renderer_name();

  private:
    QOffscreenSurface surface_;  // must outlive the context
    QOpenGLContext context_;
};

}  // namespace hepatica
