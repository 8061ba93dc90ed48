// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/offscreen_picture.h"

#include <cmath>

#include "render/osmesa_context.h"
#include "render/picture_marks.h"
#include "render/scene_view.h"

namespace hepatica {
namespace {

void draw_marks(Picture& picture, const SceneView& view, const PictureOptions& options) {
    const auto place_of = [&](const Vec3& point_mm) {
        const Pixel pixel = view.pixel_of(point_mm);
        return std::array<double, 2>{pixel.x, pixel.y};
    };
    for (const LineMark& line : options.lines) {
        std::vector<std::array<double, 2>> points;
        for (const Vec3& point : line.points_mm) points.push_back(place_of(point));
        draw_line(picture, points, line.width_px, line.colour);
    }
    for (const CircleMark& circle : options.circles) {
        const auto centre = place_of(circle.centre_mm);
        const auto rim = place_of(circle.centre_mm + circle.radius_mm * view.axes().right);
        draw_circle(picture, centre, std::hypot(rim[0] - centre[0], rim[1] - centre[1]),
                    circle.width_px, circle.colour);
    }
}

}  // namespace

OffscreenPicture draw_frame(const Frame& frame, const PictureOptions& options) {
    OsmesaContext context(options.width, options.height);
    SceneView view(context.window());
    view.set_smoothing(Smoothing::best);
    view.show(frame);
    view.set_vertex_systems(options.vertex_systems);
    view.set_vertex_segments(options.vertex_segments);
    view.set_bridges(options.bridges);
    view.set_liver(options.liver);
    view.set_tumours(options.tumours);
    view.set_volume_look(options.ct_look);
    view.set_volume(options.ct);
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
    OffscreenPicture drawn{read_picture(context.window()), renderer_name(context.window())};
    draw_marks(drawn.picture, view, options);
    return drawn;
}

OffscreenPicture draw_chart(const Chart& chart, int width, int height) {
    OsmesaContext context(width, height);
    context.window().SetMultiSamples(8);
    draw_chart(context.window(), chart);
    return {read_picture(context.window()), renderer_name(context.window())};
}

}  // namespace hepatica
