// SPDX-License-Identifier: GPL-3.0-or-later
// The vessel surface in the picture, rounded or plain; the plain one has a quarter of the triangles
// and serves pictures that must be fast. Positions and normals of the visible one are uploaded in
// every frame in which they change, triangles and colours only when they change, and the drug's
// arrival times once an injection; the drug's clock is one uniform.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/vascular_system.h"
#include "core/scene/frame.h"
#include "core/scene/surface_stretch.h"
#include "render/drawn_surface.h"
#include "render/palette.h"
#include "render/rounded_surface.h"
#include "render/surface_geometry.h"

class vtkPlane;

namespace hepatica {

// Belongs to one OpenGL context; not thread-safe.
class TreeActor {
  public:
    TreeActor();

    // Takes over a frame and highlights the vertices that a tool touches. Returns true if the
    // picture changed.
    bool update(const Frame& frame);

    // Whether the surface is drawn rounded (rounded_surface.h); on by default.
    void set_rounded(bool rounded);

    // Vascular system of each vertex of the frame (palette::vessel_system); those missing at the
    // end count as unknown.
    void set_vertex_systems(std::vector<VascularSystem> systems);
    // Couinaud's segment of each vertex of the frame, 1 to 8, whose colour replaces its system's;
    // 0, and those missing at the end, show the system.
    void set_vertex_segments(std::vector<std::uint8_t> segments);
    // 1 for each vertex of the frame to highlight, 0 for others; empty highlights none.
    // `of_branch`: in the colour of a chosen branch.
    void set_highlight(std::vector<std::uint8_t> highlight, bool of_branch = false);
    const std::vector<std::uint8_t>& highlight() const { return highlight_; }
    // The same for what a lesson wants the drug in, which stays visible under a highlight.
    void set_target(std::vector<std::uint8_t> target);
    const std::vector<std::uint8_t>& target() const { return target_; }
    // See SceneView::set_drug_scale().
    void set_drug_scale(double least_end_s) { least_drug_end_s_ = least_end_s; }
    // Whether vessels near their limit are coloured (palette::warning); off by default.
    void set_warnings(bool shown);
    // Whether stretched vessels have the colours of their stretch (palette::stretch) instead of
    // those of systems and segments; off by default. The rest positions are those of a body that
    // moves; of frames with other vertices no stretch is shown.
    void set_stretch_shown(bool shown);
    void set_rest_positions(const std::vector<Vec3>& rest_mm);
    bool shows_stretch() const { return !stretches_.empty(); }
    // Distances from the camera in mm between which the tree fades into the background.
    void set_fade(double near_mm, double far_mm);

    // Whether systems have their bright colours; off by default.
    void set_bright(bool bright);
    // The colour into which it fades.
    void set_distance(const Colour& colour);
    // See DrawnSurface::set_clip().
    void set_clip(vtkPlane* plane);
    // Whether the rounded surface has a halo (halo_actor.h); on by default. The plain surface has
    // none.
    void set_halo(bool shown);
    HaloActor& halo() { return rounded_.halo(); }

    // The plain and the rounded surface; one of them is visible at a time.
    std::array<vtkActor*, 2> actors() const { return {plain_.actor(), rounded_.actor()}; }
    const SurfaceGeometry& surface() const { return surface_; }

  private:
    // Of a vertex of the frame, of a triangle that a tear has laid bare or of another one.
    Colour colour_of(int vertex, bool bare) const;
    // Without touch, tears and warnings; `origin` is the vertex of the whole body that it comes
    // from.
    Colour own_colour_of(std::size_t vertex, std::size_t origin) const;
    void take_topology();
    void take_colours();
    void take_arrival(const DrugView& drug);
    // Returns true if it is to be drawn.
    bool take_stretch(const Frame& frame);
    // Returns true if the touched vertices changed.
    bool take_touched(const std::optional<ToolView>& tool);
    // Uploads the positions of the visible surface if they are outdated.
    void take_positions();
    void show_one();

    SurfaceGeometry surface_;
    RoundedSurface rounding_;
    DrawnSurface plain_;
    DrawnSurface rounded_;
    bool is_rounded_ = true;
    bool has_halo_ = true;
    bool plain_is_old_ = false;    // its positions are those of an earlier frame
    bool rounded_is_old_ = false;  // the same
    std::vector<VascularSystem> systems_;
    std::vector<std::uint8_t> segments_;
    std::vector<std::uint8_t> highlight_;
    bool highlights_branch_ = false;
    std::vector<std::uint8_t> target_;
    bool bright_ = false;
    std::vector<int> touched_;                               // vertices of the frame, ascending
    std::shared_ptr<const std::vector<int>> origins_;        // see TearView
    std::shared_ptr<const std::vector<std::uint8_t>> rims_;  // likewise
    std::shared_ptr<const std::vector<float>> loads_;        // likewise
    bool warnings_ = false;
    bool stretch_shown_ = false;
    SurfaceStretch stretch_{{}};
    std::vector<float> stretches_;  // per vertex of the frame; empty: not shown
    std::shared_ptr<const std::vector<std::uint8_t>> reached_before_;  // see DrugView
    std::uint64_t drug_version_ = 0;
    const void* drug_source_ = nullptr;
    double drug_time_s_ = 0.0;
    double least_drug_end_s_ = 0.0;
};

}  // namespace hepatica
