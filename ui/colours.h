// SPDX-License-Identifier: GPL-3.0-or-later
// The colours of the view as Qt's.
#pragma once

#include <QColor>

#include "render/palette.h"

namespace hepatica {

// Channels from 0 to 1.
inline QColor qcolor_of(const Colour& colour) {
    return QColor::fromRgbF(static_cast<float>(colour[0]), static_cast<float>(colour[1]),
                            static_cast<float>(colour[2]));
}

}  // namespace hepatica
