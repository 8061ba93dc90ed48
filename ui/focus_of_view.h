// SPDX-License-Identifier: GPL-3.0-or-later
// Where the keyboard focus may be: back at the view once the focused control is disabled or hidden,
// because Qt would give it to the next control, where Space or Backspace have another meaning; and
// in no panel behind another, where keys would change what nobody sees. Tab passes such panels by:
// their tabs are reached by it, and arrow keys bring the panel to the front.
#pragma once

class QMainWindow;
class QWidget;

namespace hepatica {

// Effective for controls of the view's window as long as the view lives.
void give_focus_back_to(QWidget& view);

// A control that gets the focus is scrolled into sight, unless the mouse presses it, and its panel
// comes to the front, unless the focus comes with the window, as after a dialog: then the view gets
// it. A panel that goes behind another gives the focus to the view. For the panels that the window
// has by now.
void keep_focus_in_sight(QMainWindow& window, QWidget& view);

// Gives the focus to the next control in the order of Tab, or to the one before, that lies in no
// panel behind another. False where there is none.
bool focus_next_in_sight(QMainWindow& window, bool next);

}  // namespace hepatica
