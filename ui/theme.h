// SPDX-License-Identifier: GPL-3.0-or-later
// Themes of the window: dark as in a reading room, so that the patient is the brightest thing on
// the screen; light for lecture rooms and print; and high contrast of at least 7 to 1 (WCAG 2.1,
// level AAA). UI thread only.
#pragma once

#include <QColor>
#include <QString>
#include <array>
#include <span>

#include "render/view_look.h"

class QApplication;

namespace hepatica {

// Of curves, in the order in which they are given out, of events, and of the present time. Lines
// and words are drawn in them.
struct PlotColours {
    std::array<QColor, 4> curves;
    QColor event, time;
};

struct Theme {
    const char* name;  // in the settings
    // Backgrounds: window, fields, bars, buttons; and the frames around them.
    QColor window, base, bar, button, button_hover, frame;
    QColor text, quiet, disabled, title;
    // Selected or switched on: background, border, which is also the frame around what has the
    // keys, text; and links.
    QColor accent, accent_border, accent_text, link;
    // Backgrounds of messages, their text, and errors in an input.
    QColor failure, notice, message_text, problem;
    ViewLook view;
    PlotColours plot;
};

// The first is the default.
std::span<const Theme> themes();
// The first theme if there is none of this name.
const Theme& theme_named(const QString& name);

// For a plot on this ground: those of the theme whose fields have the most similar one.
const PlotColours& plot_colours_on(const QColor& ground);

// Property of widgets that show their focus themselves; all others get a frame.
inline constexpr const char* paints_own_focus = "paintsOwnFocus";

// Applies the theme to all windows.
void apply_theme(QApplication& application, const Theme& theme = themes().front());

}  // namespace hepatica
