// SPDX-License-Identifier: GPL-3.0-or-later
// Checks for a display and for OpenGL before anything needs them, so that a missing part is named
// instead of a crash. This VTK loads OpenGL functions through GLX, available with X11 and Xwayland;
// in an EGL context, as every Wayland context is, it would draw nothing.
#pragma once

#include <QString>

namespace hepatica {

// Before the QApplication: chooses xcb and a number of rendering threads that leaves a core to the
// simulation, unless the user has set either, and a 3.2 core profile for all contexts.
void prepare_opengl();

// Before the QApplication, which would abort: empty if a display answers, else what is missing and
// how to help.
QString display_problem();

// After it: empty if OpenGL 3.2 works through GLX, else what is missing and how to help.
QString opengl_problem();

}  // namespace hepatica
