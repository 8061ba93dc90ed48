// SPDX-License-Identifier: GPL-3.0-or-later
// Conversion between device-independent points of the window (Qt) and pixels of the picture
// (OpenGL).
#pragma once

#include <QPointF>
#include <QSize>

#include "render/scene_view.h"

namespace hepatica {

// `ratio`: pixels per point of the widget's own screen (QWidget::devicePixelRatioF), > 0.
Pixel pixel_at(const QPointF& point, double ratio);
QPointF point_at(const Pixel& pixel, double ratio);
// Size of the widget's framebuffer as Qt makes it: each edge rounded to whole pixels.
QSize pixel_size(const QSize& points, double ratio);

}  // namespace hepatica
