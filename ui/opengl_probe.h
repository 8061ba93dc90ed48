// SPDX-License-Identifier: GPL-3.0-or-later
// Asks for a display and for OpenGL before anything needs them, so that what is missing is named
// and nothing crashes. This VTK finds OpenGL's functions through GLX, which X11 and Xwayland have;
// in a context that came through EGL, as every Wayland context does, it would draw nothing.
#pragma once

#include <QString>

namespace hepatica {

// Before the QApplication: xcb unless the user chose a platform, a 3.2 core profile for every
// context, and unless the user chose how many threads draw where there is no graphics card, one
// core that is left to the simulation.
void prepare_opengl();

// Before the QApplication, which would abort: empty where there is a display that answers, else
// what is missing and what to install or set.
QString display_problem();

// After it: empty where OpenGL 3.2 works through GLX, else what is missing and what to install.
QString opengl_problem();

}  // namespace hepatica
