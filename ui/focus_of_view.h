// SPDX-License-Identifier: GPL-3.0-or-later
// Gives the keyboard back to the view when the control that has it is disabled or goes. Qt gives it
// to whichever control comes next, where Space or Backspace mean something else.
#pragma once

class QWidget;

namespace hepatica {

// From now on, as long as the view lives, for controls of its window.
void give_focus_back_to(QWidget& view);

}  // namespace hepatica
