// SPDX-License-Identifier: GPL-3.0-or-later
// Asks for OpenGL before anything needs it, so that a missing driver is named and not a crash.
#pragma once

#include <QString>

namespace hepatica {

// Before the QApplication: xcb (which this VTK needs) unless the user chose a platform, and a 3.2
// core profile for every context.
void prepare_opengl();

// Before the QApplication, which would abort: empty where there is a display to connect to.
QString display_problem();

// After it: empty where OpenGL 3.2 works, else what is missing and what to install.
QString opengl_problem();

}  // namespace hepatica
