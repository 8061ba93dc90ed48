// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/opengl_probe.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSurfaceFormat>

namespace hepatica {
namespace {

constexpr int major_version = 3;
constexpr int minor_version = 2;

}  // namespace

void prepare_opengl() {
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "xcb");
    QSurfaceFormat format;
    format.setVersion(major_version, minor_version);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8);
    QSurfaceFormat::setDefaultFormat(format);
}

QString display_problem() {
    const bool needs_x11 = qgetenv("QT_QPA_PLATFORM").startsWith("xcb");
    if (!needs_x11 || !qEnvironmentVariableIsEmpty("DISPLAY")) return {};
    return "There is no display: the variable DISPLAY is not set. Start the program in a graphical "
           "session, or under xvfb-run; hepatica-cli makes pictures without any display.";
}

QString opengl_problem() {
    const QString remedy =
        "Install libgl1-mesa-dri (software rendering) or your graphics card's driver, and start "
        "the program on an X11 display with GLX. hepatica-cli makes pictures without any display.";
    QOpenGLContext context;
    if (!context.create()) return "No OpenGL context can be made. " + remedy;
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!surface.isValid() || !context.makeCurrent(&surface)) {
        return "OpenGL cannot draw on this display. " + remedy;
    }
    const auto version = context.format().version();
    context.doneCurrent();
    if (version < qMakePair(major_version, minor_version)) {
        return QString("OpenGL %1.%2 is too old; %3.%4 is needed. ")
                   .arg(version.first)
                   .arg(version.second)
                   .arg(major_version)
                   .arg(minor_version) +
               remedy;
    }
    return {};
}

}  // namespace hepatica
