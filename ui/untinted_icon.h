// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of a patient as an icon of a list: a row that is chosen would tint it with the theme's
// colour of choice, and nothing may tint a CT or the colours of vessels.
#pragma once

#include <QIcon>
#include <QPixmap>

namespace hepatica {

inline QIcon untinted(const QPixmap& picture) {
    QIcon icon(picture);
    icon.addPixmap(picture, QIcon::Selected);
    return icon;
}

}  // namespace hepatica
