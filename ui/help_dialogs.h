// SPDX-License-Identifier: GPL-3.0-or-later
// The guide, keys and mouse gestures, and what program this is.
#pragma once

#include <QString>

class QWidget;

namespace hepatica {

// One at a time.
void show_guide(QWidget& parent);
void show_cheat_sheet(QWidget& parent);
void show_about(QWidget& parent, const QString& renderer);

}  // namespace hepatica
