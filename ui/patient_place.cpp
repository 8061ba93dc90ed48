// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/patient_place.h"

#include <cmath>

namespace hepatica {
namespace {

QString along(double mm, int decimals, QChar positive, QChar negative) {
    return QString("%1 %L2")
        .arg(mm < 0.0 ? negative : positive)
        .arg(std::abs(mm), 0, 'f', decimals);
}

}  // namespace

QString patient_place(const Vec3& position_mm, int decimals) {
    return QString("%1  %2  %3 mm")
        .arg(along(position_mm.x(), decimals, 'L', 'R'), along(position_mm.y(), decimals, 'P', 'A'),
             along(position_mm.z(), decimals, 'H', 'F'));
}

}  // namespace hepatica
