// SPDX-License-Identifier: GPL-3.0-or-later
// The icons of what the mouse does, painted here: one look, at any density of the screen, without
// files.
#pragma once

#include <QIcon>

#include "ui/actions.h"

namespace hepatica {

// Null for actions without one.
QIcon icon_of(ActionId id);

}  // namespace hepatica
