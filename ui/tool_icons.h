// SPDX-License-Identifier: GPL-3.0-or-later
// Icons of the mouse modes and tools, painted in code: uniform, sharp at any pixel density, without
// files.
#pragma once

#include <QIcon>

#include "ui/actions.h"

namespace hepatica {

// Null for actions without an icon.
QIcon icon_of(ActionId id);

}  // namespace hepatica
