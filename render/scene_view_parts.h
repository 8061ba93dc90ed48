// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a SceneView: its actors, the data of the newest frame and the user's choices.
// Included by scene_view.cpp alone.
#pragma once

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "render/annotations.h"
#include "render/bleeding_actor.h"
#include "render/crosshair_actor.h"
#include "render/depth_stem.h"
#include "render/figure_label.h"
#include "render/ghost_actor.h"
#include "render/grab_actor.h"
#include "render/obstacle_actors.h"
#include "render/orientation_marker.h"
#include "render/palette.h"
#include "render/scene_view.h"
#include "render/stroke_line.h"
#include "render/tool_actor.h"
#include "render/tree_actor.h"
#include "render/volume_actor.h"
#include "render/weak_line_actor.h"

namespace hepatica {

struct SceneView::Parts {
    explicit Parts(vtkRenderWindow& render_window)
        : window(render_window), annotations(*renderer), orientation(render_window) {}

    PictureSize picture_size() const {
        const int* size = window.GetSize();
        // In small pictures the annotations shrink, so that they do not cover the patient.
        const double room = std::clamp(size[1] / (600.0 * pixel_ratio), 0.6, 1.0);
        // The legend's letters shrink in thumbnails alone, to three quarters at least, which are 9
        // points of print.
        const double legend_room = std::clamp(size[1] / (300.0 * pixel_ratio), 0.75, 1.0);
        return {size[0],
                size[1],
                pixel_ratio * room,
                pixel_ratio * legend_room,
                pixel_ratio,
                pixel_ratio * covered[0],
                pixel_ratio * covered[1]};
    }
    // Draws each thing once: the liver's wall as an organ where the liver is shown, a tumour as an
    // obstacle where it is one. One that was painted since is none yet.
    void fit_wall_to_liver() { obstacles.set_wall_visible(!liver.shows()); }
    void fit_tumours_to_obstacles() {
        tumours.set_surface(obstacles.parts_beside_solids(all_tumours));
        legend.tumours = tumours.shows() || obstacles.has_solids();
    }
    // The way that the tool has to go. Returns true if the picture changed.
    bool lead_stem() {
        return stem.update(tool.shown(), tree.surface().positions_mm(), marks.shown(),
                           Vec3(renderer->GetActiveCamera()->GetDirectionOfProjection()));
    }
    // After the tool, on whose figure the number must not lie.
    void place_stem() {
        std::vector<ThickStretch> of_tool = tool.outlines();
        if (const auto figure = tool.label_box()) of_tool.push_back(covering(*figure));
        stem.place(pixel_ratio, Vec3(renderer->GetActiveCamera()->GetDirectionOfProjection()),
                   of_tool);
    }
    void find_colours_shown() {
        set_colours_shown(legend, systems, segments, drug);
        find_highlights_shown();
    }
    void find_highlights_shown() {
        set_highlights_shown(legend, tree.target(), tree.highlight(), drug);
    }
    // The driver's name is read once, when a volume is first shown.
    void prepare_volume() {
        if (!volume.empty() && !by_card) by_card = !is_software_renderer(renderer_name(window));
        volume.prepare(by_card.value_or(false));
    }
    Projection projection() {
        const int* size = window.GetSize();
        return {*renderer->GetActiveCamera(), size[0], size[1]};
    }
    double aspect() const {
        const PictureSize size = picture_size();
        return static_cast<double>(std::max(size.width, 1)) / std::max(size.height, 1);
    }

    vtkRenderWindow& window;
    vtkNew<vtkRenderer> renderer;
    vtkSmartPointer<vtkLight> light_from_below;
    TreeActor tree;
    GhostActor liver{liver_ghost};
    GhostActor tumours{tumour_ghost};
    TriangleMesh all_tumours;  // obstacles among them
    ObstacleActors obstacles{*renderer};
    VolumeActor volume{*renderer};
    GrabActor grab;
    StrokeLine stroke{*renderer};
    WeakLineActor weak_lines;
    CrosshairActor crosshair;
    ToolActor tool{*renderer};
    DepthStem stem{*renderer};
    FigureLabel pull_force{*renderer, palette::grab_line};
    BleedingActor bleeding{*renderer};
    bool blood_shown = true;
    PictureWords words;
    BridgeActor bridges{*renderer};
    MarkActors marks{*renderer};
    MeasureMarks chosen_branch{*renderer};  // its line, without a text
    MeasureMarks measures{*renderer};
    Annotations annotations;
    OrientationMarker orientation;
    vtkNew<vtkPlane> clip_plane;
    std::optional<ClipPlane> clip;
    std::vector<VascularSystem> systems;
    std::vector<std::uint8_t> segments;
    DrugView drug;  // from the newest frame
    LegendContent legend;
    ViewLook look = dark_look;
    double pixel_ratio = 1.0;
    std::array<int, 2> covered{};   // covered heights in points at the top and bottom
    std::optional<bool> by_card;    // whether a graphics card draws; none: not known yet
    double least_drug_end_s = 0.0;  // least end of the drug's colour scale
    bool annotated = true;
    bool warned = false;
    bool at_rest = true;        // pictures need not be fast
    bool moving = false;        // whether fast or not
    bool looked = false;        // a camera was chosen for the present tree
    bool turned = false;        // a new view was chosen since the last picture
    double shown_aspect = 0.0;  // aspect for which the camera was chosen or adapted; 0: none
};

}  // namespace hepatica
