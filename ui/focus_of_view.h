// SPDX-License-Identifier: GPL-3.0-or-later
// Where the keyboard focus may be: back at the view once the focused control is disabled or hidden,
// because Qt would give it to the next control, where Space or Backspace have another meaning; and
// in no panel behind another, where keys would change what nobody sees.
#pragma once

class QMainWindow;
class QWidget;

namespace hepatica {

// Effective for controls of the view's window as long as the view lives.
void give_focus_back_to(QWidget& view);

// A control that gets the focus is scrolled into sight, unless the mouse presses it, and its panel
// comes to the front; a panel that goes behind another gives the focus to the view. For the panels
// that the window has by now.
void keep_focus_in_sight(QMainWindow& window, QWidget& view);

}  // namespace hepatica
