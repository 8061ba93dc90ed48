// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/patient_place.h"

#include <cmath>

namespace hepatica {
namespace {

QString along(double mm, QChar positive, QChar negative) {
    return QString("%1 %2").arg(mm < 0.0 ? negative : positive).arg(std::lround(std::abs(mm)));
}

}  // namespace

QString patient_place(const Vec3& position_mm) {
    return QString("%1  %2  %3 mm")
        .arg(along(position_mm.x(), 'L', 'R'), along(position_mm.y(), 'P', 'A'),
             along(position_mm.z(), 'H', 'F'));
}

}  // namespace hepatica
