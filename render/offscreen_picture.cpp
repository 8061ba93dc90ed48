// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/offscreen_picture.h"

#include "render/osmesa_context.h"
#include "render/scene_view.h"

namespace hepatica {

OffscreenPicture draw_frame(const Frame& frame, const PictureOptions& options) {
    OsmesaContext context(options.width, options.height);
    SceneView view(context.window());
    view.set_smoothing(Smoothing::best);
    view.show(frame);
    view.set_vertex_systems(options.vertex_systems);
    view.set_vertex_segments(options.vertex_segments);
    view.set_bridges(options.bridges);
    view.set_liver(options.liver);
    view.set_caption(options.caption);
    view.set_annotations_visible(options.annotations);
    view.look_from(options.view);
    if (options.fitted_box_mm)
        look_from(view.camera(), options.view, options.fitted_box_mm->front(),
                  options.fitted_box_mm->back(),
                  static_cast<double>(options.width) / options.height);
    orbit(view.camera(), options.turn_right_deg, options.turn_up_deg);
    view.zoom_by(options.zoom);
    view.render();
    return {read_picture(context.window()), renderer_name(context.window())};
}

OffscreenPicture draw_chart(const Chart& chart, int width, int height) {
    OsmesaContext context(width, height);
    context.window().SetMultiSamples(8);
    draw_chart(context.window(), chart);
    return {read_picture(context.window()), renderer_name(context.window())};
}

}  // namespace hepatica
