// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/opengl_probe.h"

#include <QLibrary>
#include <QOpenGLContext>
#include <QSurfaceFormat>
#include <QThread>
#include <algorithm>

#include "ui/hidden_context.h"
#include "ui/words.h"

namespace hepatica {
namespace {

constexpr int major_version = 3;
constexpr int minor_version = 2;
constexpr const char* threads_of_llvmpipe = "LP_NUM_THREADS";  // for Mesa's software renderer

// Asks libX11, which Qt loads anyway and which handles sockets, hosts and permissions.
bool x_display_answers() {
    if (qEnvironmentVariableIsEmpty("DISPLAY")) return false;
    QLibrary x11("X11", 6);
    const auto open_display = reinterpret_cast<void* (*)(const char*)>(x11.resolve("XOpenDisplay"));
    const auto close_display = reinterpret_cast<int (*)(void*)>(x11.resolve("XCloseDisplay"));
    if (open_display == nullptr || close_display == nullptr) return true;  // Qt will report it
    void* display = open_display(nullptr);
    if (display == nullptr) return false;
    close_display(display);
    return true;
}

}  // namespace

void prepare_opengl() {
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "xcb");
    if (qEnvironmentVariableIsEmpty(threads_of_llvmpipe))
        qputenv(threads_of_llvmpipe,
                QByteArray::number(std::max(1, QThread::idealThreadCount() - 1)));
    QSurfaceFormat format;
    format.setVersion(major_version, minor_version);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8);
    QSurfaceFormat::setDefaultFormat(format);
}

QString display_problem() {
    const QByteArray platform = qgetenv("QT_QPA_PLATFORM");
    if (platform.startsWith("wayland")) {
        return Words::tr(
            "QT_QPA_PLATFORM asks for Wayland, where the three-dimensional view cannot draw: it "
            "needs GLX. Unset QT_QPA_PLATFORM; the window then comes through Xwayland, which "
            "the package xwayland installs.");
    }
    if (!platform.startsWith("xcb") || x_display_answers()) return {};
    const QString other = Words::tr("hepatica-cli makes pictures without any display.");
    if (!qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY")) {
        return Words::tr(
                   "This is a Wayland session without an X server, and the three-dimensional view "
                   "needs one. Install the package xwayland and log in again; %1")
            .arg(other);
    }
    if (qEnvironmentVariableIsEmpty("DISPLAY")) {
        return Words::tr(
                   "There is no display: the variable DISPLAY is not set. Start the program in a "
                   "graphical session, or under xvfb-run; %1")
            .arg(other);
    }
    return Words::tr(
               "The display %1 cannot be reached. Set DISPLAY to that of your graphical session, "
               "allow this user "
               "there (xhost), or start under xvfb-run; %2")
        .arg(qEnvironmentVariable("DISPLAY"), other);
}

QString opengl_problem() {
    const QString remedy = Words::tr(
        "Install libgl1-mesa-dri (software rendering) or your graphics card's driver, and start "
        "the program on an X11 display with GLX. hepatica-cli makes pictures without any display.");
    HiddenContext hidden;
    if (!hidden.context().isValid())
        return Words::tr("No OpenGL context can be made. %1").arg(remedy);
    if (hidden.context().nativeInterface<QNativeInterface::QGLXContext>() == nullptr) {
        return Words::tr(
            "OpenGL does not come through GLX here, which the three-dimensional view needs. "
            "Unset QT_QPA_PLATFORM and QT_XCB_GL_INTEGRATION, and start the program on an X11 "
            "display with GLX (under Wayland: install xwayland).");
    }
    if (!hidden.make_current()) {
        return Words::tr("OpenGL cannot draw on this display. %1").arg(remedy);
    }
    const auto version = hidden.context().format().version();
    hidden.context().doneCurrent();
    if (version < qMakePair(major_version, minor_version)) {
        return Words::tr("OpenGL %1.%2 is too old; %3.%4 is needed. %5")
            .arg(version.first)
            .arg(version.second)
            .arg(major_version)
            .arg(minor_version)
            .arg(remedy);
    }
    return {};
}

}  // namespace hepatica
