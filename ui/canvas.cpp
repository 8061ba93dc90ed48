// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas.h"

#include <memory>
#include <utility>

#include "render/scene_view.h"
#include "ui/image_canvas.h"
#include "ui/surface_canvas.h"

namespace hepatica {

Canvas* make_canvas(QWidget& view, CanvasPainter painter) {
    auto hidden = std::make_unique<HiddenContext>();
    if (hidden->make_current() && is_software_renderer(hidden->renderer_name()))
        return new ImageCanvas(view, std::move(hidden), std::move(painter));
    return new SurfaceCanvas(view, std::move(painter));
}

}  // namespace hepatica
