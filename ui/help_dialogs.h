// SPDX-License-Identifier: GPL-3.0-or-later
// Dialogs of the Help menu: guide, keys and mouse gestures, and program information.
#pragma once

#include <QString>

class QWidget;

namespace hepatica {

// Only one guide is open at a time.
void show_guide(QWidget& parent);
void show_cheat_sheet(QWidget& parent);
void show_about(QWidget& parent, const QString& renderer);

}  // namespace hepatica
