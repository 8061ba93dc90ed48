// SPDX-License-Identifier: GPL-3.0-or-later
// The look of the window: dark and quiet, as in a reading room, so that the patient is the
// brightest thing on the screen.
#pragma once

class QApplication;

namespace hepatica {

void apply_theme(QApplication& application);

}  // namespace hepatica
