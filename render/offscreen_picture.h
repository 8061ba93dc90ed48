// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures without a display, for headless programs: one call makes one picture. Only targets for
// which hepatica_use_osmesa() was called contain it.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/vascular_system.h"
#include "core/image/volume.h"
#include "core/mesh/tet_mesh.h"
#include "core/scene/frame.h"
#include "render/bridge_actor.h"
#include "render/camera.h"
#include "render/chart.h"
#include "render/palette.h"
#include "render/picture.h"
#include "render/volume_look.h"

namespace hepatica {

// Marks of a figure, drawn over everything else.
struct LineMark {
    std::vector<Vec3> points_mm{};
    Colour colour = palette::text;
    double width_px = 4.0;
};
struct CircleMark {
    Vec3 centre_mm = Vec3::Zero();
    double radius_mm = 5.0;
    Colour colour = palette::text;
    double width_px = 4.0;
};

struct PictureOptions {
    int width = 1280;
    int height = 960;
    ViewDirection view = ViewDirection::anterior;
    // Opposite corners of the box that fits at zoom 1, so that pictures of a moving tree share one
    // camera; none takes the box of the frame's tree.
    std::optional<std::array<Vec3, 2>> fitted_box_mm{};
    double zoom = 1.0;
    double turn_right_deg = 0.0;  // turned away from the view, as with the mouse
    double turn_up_deg = 0.0;
    std::string caption{};
    bool annotations = true;                       // legend, scale bar, orientation
    std::vector<VascularSystem> vertex_systems{};  // one per vertex; empty: all unknown
    std::vector<std::uint8_t>
        vertex_segments{};               // Couinaud's, 1 to 8; 0 or missing: the system's colour
    std::vector<BridgeView> bridges{};   // gaps that might be bridged
    TriangleMesh liver{};                // drawn translucent; may be empty
    TriangleMesh tumours{};              // the same
    std::shared_ptr<const Volume> ct{};  // volume rendering around the vessels; may be null
    VolumeLook ct_look{};
    std::vector<LineMark> lines{};
    std::vector<CircleMark> circles{};
};

struct OffscreenPicture {
    Picture picture;
    std::string renderer;  // name of the OpenGL renderer
};

// Throws UsageError where the size is not 1 to 16384 pixels each way, and Error where no OpenGL
// context can be made.
OffscreenPicture draw_frame(const Frame& frame, const PictureOptions& options);
OffscreenPicture draw_chart(const Chart& chart, int width = 960, int height = 640);

}  // namespace hepatica
