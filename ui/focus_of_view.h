// SPDX-License-Identifier: GPL-3.0-or-later
// Returns the keyboard focus to the view when the focused control is disabled or hidden. Qt would
// give it to the next control, where Space or Backspace have another meaning.
#pragma once

class QWidget;

namespace hepatica {

// Effective for controls of the view's window as long as the view lives.
void give_focus_back_to(QWidget& view);

}  // namespace hepatica
