// SPDX-License-Identifier: GPL-3.0-or-later
// The looks of the window, each one value: dark and quiet as in a reading room, so that the patient
// is the brightest thing on the screen; light, for lecture rooms and print; and one of high
// contrast, whose text stands out by at least 7 to 1 (WCAG 2.1, level AAA).
#pragma once

#include <QColor>
#include <QString>
#include <span>

#include "render/view_look.h"

class QApplication;

namespace hepatica {

struct Theme {
    const char* name;  // as settings keep it
    // What things stand on: the window, what is written into, bars, buttons, and frames around
    // them.
    QColor window, base, bar, button, button_hover, frame;
    QColor text, quiet, disabled, title;
    // What is chosen or on, with its border and the text on it; links.
    QColor accent, accent_border, accent_text, link;
    // Behind messages, and their text; what is wrong with an input.
    QColor failure, notice, message_text, problem;
    ViewLook view;
};

// The first is what the program begins with.
std::span<const Theme> themes();
// The first where none is called so.
const Theme& theme_named(const QString& name);

// Name of a property of widgets that show by themselves that they have the keyboard; around all
// others there is a frame then.
inline constexpr const char* paints_own_focus = "paintsOwnFocus";

// Of all windows, from now on.
void apply_theme(QApplication& application, const Theme& theme = themes().front());

}  // namespace hepatica
