// SPDX-License-Identifier: GPL-3.0-or-later
// Dialogs of the Help menu: guide, keys and mouse gestures, and program information.
#pragma once

#include <QString>

class QWidget;

namespace hepatica {

// Only one guide is open at a time.
void show_guide(QWidget& parent);
// `mouse_scheme`: see mouse_scheme_named().
void show_cheat_sheet(QWidget& parent, const QString& mouse_scheme);
void show_about(QWidget& parent, const QString& renderer);

}  // namespace hepatica
