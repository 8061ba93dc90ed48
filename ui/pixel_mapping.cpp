// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pixel_mapping.h"

namespace hepatica {

Pixel pixel_at(const QPointF& point, double ratio) {
    return {point.x() * ratio, point.y() * ratio};
}

QPointF point_at(const Pixel& pixel, double ratio) {
    return {pixel.x / ratio, pixel.y / ratio};
}

QSize pixel_size(const QSize& points, double ratio) {
    return points * ratio;
}

}  // namespace hepatica
