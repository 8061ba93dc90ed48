// SPDX-License-Identifier: GPL-3.0-or-later
// Icon for a picture of a patient in a list. Qt would tint a selected icon, but a CT and the
// colours of vessels must not be tinted.
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
