// SPDX-License-Identifier: GPL-3.0-or-later
// The three-dimensional picture of a Frame in any VTK render window: vessels with the drug in them,
// the liver's translucent surface, tumours, obstacles, the line of the pull, the tool and its
// force, legend, scale and orientation; and picking, from a pixel to the point of the patient under
// it.
#pragma once

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
#include "render/clip_plane.h"
#include "render/legend_rows.h"
#include "render/mark_actors.h"
#include "render/measure_marks.h"
#include "render/projection.h"
#include "render/surface_geometry.h"
#include "render/view_look.h"
#include "render/volume_look.h"

class vtkCamera;
class vtkRenderWindow;

namespace hepatica {

// How much a picture may cost. none: as fast as possible. cheap: rounded surface, edges smoothed by
// a pass over the finished picture, which software renderers can afford at rest. best: rounded
// surface, a light from below, and eight samples a pixel.
enum class Smoothing { none, cheap, best };

// Name of the OpenGL renderer of the window, whose context must be current; empty if unknown.
std::string renderer_name(vtkRenderWindow& window);
// True for renderers without a graphics card, such as Mesa's llvmpipe.
bool is_software_renderer(const std::string& renderer_name);

// What a highlight shows, for the legend.
enum class HighlightOf { downstream, branch };

// Use it only from the thread whose OpenGL context is the window's; the window must outlive it.
class SceneView {
  public:
    explicit SceneView(vtkRenderWindow& window);
    ~SceneView();
    SceneView(const SceneView&) = delete;
    SceneView& operator=(const SceneView&) = delete;

    // Takes over a frame without drawing. Costs one pass over the surface; while the drug flows and
    // the body is at rest, one uniform goes to the card. Returns true if the picture changed, so
    // that an unchanged scene need not be drawn again.
    bool show(const Frame& frame);
    // Draws into the window. `pixel_ratio`: device pixels per point (1 on ordinary screens).
    void render(double pixel_ratio = 1.0);

    // Per vertex of the frame; see TreeActor.
    void set_vertex_systems(std::vector<VascularSystem> systems);
    void set_vertex_segments(std::vector<std::uint8_t> segments);
    void set_highlight(std::vector<std::uint8_t> vertices,
                       HighlightOf what = HighlightOf::downstream);
    const std::vector<std::uint8_t>& highlight() const;
    // The centreline of a chosen branch in the deformed body, seen through what lies before it;
    // empty: none. Returns true if the picture changed.
    bool set_chosen_branch(std::vector<Vec3> line_mm);
    void set_target(std::vector<std::uint8_t> vertices);
    const std::vector<std::uint8_t>& target() const;
    const LegendContent& legend() const;  // what it explains
    // The stroke being drawn on the vessels, from one point to another; none removes it.
    void set_stroke(const std::optional<std::array<Vec3, 2>>& stroke);
    // Where the slices of the CT cross; none removes it. Returns true if the picture changed.
    bool set_crosshair(const std::optional<Vec3>& position_mm);
    // Places to be found, such as a lesson's. Returns true if the picture changed.
    bool set_marks(std::vector<MarkView> marks);
    const std::vector<MarkView>& marks() const;
    // See MarkActors::place_at().
    std::optional<Vec3> mark_at(const Pixel& pixel, double times) const;
    // Measurements. Returns true if the picture changed.
    bool set_measures(std::vector<MeasureView> measures);
    const std::vector<MeasureView>& measures() const;
    // Gaps that might be bridged, drawn as dashed lines.
    void set_bridges(std::vector<BridgeView> bridges);
    void set_liver(const TriangleMesh& surface);  // an empty one removes it
    void set_liver_visible(bool visible);
    // All tumours as one surface at rest; an empty one removes them.
    void set_tumours(const TriangleMesh& surface);
    // The CT around the vessels in Hounsfield units; null removes it, and its memory is freed with
    // the next picture.
    void set_volume(std::shared_ptr<const Volume> ct);
    bool set_volume_look(const VolumeLook& look);  // true if a volume is shown
    // Cuts vessels, tumours, liver, obstacles and CT open; none shows them whole.
    void set_clip(const std::optional<ClipPlane>& plane);
    void set_look(const ViewLook& look);  // dark_look by default
    // Translates all drawn words except the caption; English by default.
    void set_words(const PictureWords& words);
    // Whether a rim sets off vessels that pass in front of others (halo_actor.h); on by default.
    // Pictures with Smoothing::none have none.
    void set_halos_visible(bool visible);
    bool set_caption(const std::string& text);  // true if the text changed
    void set_annotations_visible(bool visible);
    // Heights in points at the top and bottom of the picture that something else covers; legend,
    // scale and caption keep clear of them. Returns true if they changed.
    bool set_covered(int top, int bottom);
    // The drug's colour scale ends at this time or later, from the next frame on, so that two
    // pictures side by side can share one scale. 0, the default, gives each drug its own scale.
    void set_drug_scale(double least_end_s);
    // Whether vessels that are near tearing are coloured, from the next frame on; off by default.
    void set_warnings_visible(bool visible);
    // See TreeActor; shown from the next frame on.
    void set_stretch_visible(bool visible);
    void set_rest_positions(const std::vector<Vec3>& rest_mm);
    // Whether the blood that torn vessels lost is shown, from the next frame on; on by default.
    void set_blood_visible(bool visible);
    void set_smoothing(Smoothing smoothing);  // `best` by default
    // While anything moves the legend keeps its corner, as it does with Smoothing::none; off by
    // default.
    void set_moving(bool moving);

    // Looks from a standard direction so that the whole tree of the last frame fits.
    void look_from(ViewDirection direction);
    vtkCamera& camera();
    // Takes over the camera of the other view; returns true if it differed.
    bool look_as(SceneView& other);

    // The first point of the vessel surface under the pixel; clipped parts are ignored.
    SurfacePick pick(const Pixel& pixel) const;
    ViewAxes axes() const;
    ViewRay ray_through(const Pixel& pixel) const;
    // The point under the pixel in the plane through `depth_mm` parallel to the picture: the
    // present end of a drag that began at that point.
    Vec3 point_at_depth(const Pixel& pixel, const Vec3& depth_mm) const;
    // The pixel at which a point of the patient appears.
    Pixel pixel_of(const Vec3& position_mm) const;

    // The rectangle where the legend was drawn last; empty where it was not.
    PictureBox legend_box() const;
    bool shows_caption() const;  // in the last picture
    // Boxes of the labels of measurements, in the last picture.
    const std::vector<PictureBox>& measure_labels() const;
    // Boxes of a tool's force and of its distance, as far as they are shown, in the last picture.
    std::vector<PictureBox> tool_labels() const;

    // Index of the bridge whose line passes nearest to the pixel, within `reach` pixels; -1 for
    // none.
    int bridge_at(const Pixel& pixel, double reach) const;

    // Orbit and pan by a movement of the mouse in pixels; zoom by a factor > 0.
    void drag_orbit(const Pixel& from, const Pixel& to);
    void drag_pan(const Pixel& from, const Pixel& to);
    void zoom_by(double factor);
    // Turns in the direction of drag_orbit(), by degrees to the right and down.
    void turn_by(double right_deg, double down_deg);
    // Fits the whole tree without changing the viewing direction.
    void show_whole();

  private:
    void keep_in_sight();
    // The number of surface vertices that appear in each of the boxes.
    std::vector<int> vertices_within(const std::vector<PictureBox>& boxes) const;

    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace hepatica
