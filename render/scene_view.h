// SPDX-License-Identifier: GPL-3.0-or-later
// The three-dimensional picture of a Frame in any VTK render window: vessels with the drug in them,
// the liver's ghost, tumours, obstacles, the line of the pull, the tool and its force, legend,
// scale and orientation; and the way back from a pixel to the point of the patient under it.
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

// How much is spent on a picture: nothing, for those that must be quick; the surface is rounded and
// its edges smoothed by a pass over the finished picture, which software renderers can afford at
// rest; or the surface is rounded, lit from below as well, and has eight samples a pixel.
enum class Smoothing { none, cheap, best };

// What the OpenGL driver of the window, whose context must be current, calls itself.
std::string renderer_name(vtkRenderWindow& window);
// True for renderers without a graphics card, as Mesa's llvmpipe.
bool is_software_renderer(const std::string& renderer_name);

// Belongs to the thread whose OpenGL context is the window's; the window must outlive it.
class SceneView {
  public:
    explicit SceneView(vtkRenderWindow& window);
    ~SceneView();
    SceneView(const SceneView&) = delete;
    SceneView& operator=(const SceneView&) = delete;

    // Takes over a frame; draws nothing yet. Costs one pass over the surface; with the drug running
    // and the body at rest, one uniform goes to the card. Returns true if the picture is another
    // now, so that a scene at rest need not be drawn again.
    bool show(const Frame& frame);
    // Draws into the window. `pixel_ratio`: device pixels per point (1 on plain screens).
    void render(double pixel_ratio = 1.0);

    void set_vertex_systems(std::vector<VascularSystem> systems);
    void set_vertex_segments(std::vector<std::uint8_t> segments);
    void set_highlight(std::vector<std::uint8_t> vertices);
    // What is being drawn on the vessels, from one point to another; none removes it.
    void set_stroke(const std::optional<std::array<Vec3, 2>>& stroke);
    // Where slices of the CT cross; none removes it. True if the picture is another now.
    bool set_crosshair(const std::optional<Vec3>& position_mm);
    // Places to be found, as a lesson's; true if the picture is another now.
    bool set_marks(std::vector<MarkView> marks);
    const std::vector<MarkView>& marks() const;
    // Lines that were measured; true if the picture is another now.
    bool set_measures(std::vector<MeasureView> measures);
    const std::vector<MeasureView>& measures() const;
    // Gaps that might be bridged; drawn as dashed lines.
    void set_bridges(std::vector<BridgeView> bridges);
    void set_liver(const TriangleMesh& surface);  // an empty one removes it
    void set_liver_visible(bool visible);
    // All of them as one surface, at rest; an empty one removes them.
    void set_tumours(const TriangleMesh& surface);
    // The CT around the vessels, in Hounsfield units; null: none. It costs nothing then, and its
    // memory comes back with the next picture.
    void set_volume(std::shared_ptr<const Volume> ct);
    bool set_volume_look(const VolumeLook& look);  // true if the picture is another now
    // Cuts vessels, tumours, liver and CT open; none shows them whole.
    void set_clip(const std::optional<ClipPlane>& plane);
    void set_look(const ViewLook& look);  // dark at first
    // What is drawn in words from now on, but for the caption; English at first.
    void set_words(const PictureWords& words);
    // Whether vessels that pass in front of others are set off by a rim, as at first; pictures that
    // must be quick (Smoothing::none) have none.
    void set_halos_visible(bool visible);
    bool set_caption(const std::string& text);  // true if the picture is another now
    void set_annotations_visible(bool visible);
    // So many points of the picture, at its top and foot, lie under something else: legend, scale
    // and caption stand beside it. True if it is another.
    bool set_covered(int top, int bottom);
    // The drug's colours reach to the end of this time at least, from the next frame on: two
    // pictures beside each other have one scale. 0, as at first: each drug's own.
    void set_drug_scale(double least_end_s);
    // Whether vessels that are near tearing are coloured, from the next frame on; not at first.
    void set_warnings_visible(bool visible);
    void set_smoothing(Smoothing smoothing);  // `best` at first

    // The box that look_from() fits: the tree's, as of the last frame.
    void look_from(ViewDirection direction);
    vtkCamera& camera();
    // Looks from where the other view looks; true if it did not already.
    bool look_as(SceneView& other);

    // Of what is drawn: what is clipped away is not met.
    SurfacePick pick(const Pixel& pixel) const;
    ViewAxes axes() const;
    ViewRay ray_through(const Pixel& pixel) const;
    // The point under the pixel in the plane through `depth_mm` parallel to the picture: where a
    // drag that began at that point has come to.
    Vec3 point_at_depth(const Pixel& pixel, const Vec3& depth_mm) const;
    // Where a point of the patient appears in the picture.
    Pixel pixel_of(const Vec3& position_mm) const;

    // Where the legend was drawn last.
    PictureBox legend_box() const;
    bool shows_caption() const;  // as it was drawn last
    // Of the labels of what was measured, as they were drawn last.
    const std::vector<PictureBox>& measure_labels() const;

    // The bridge whose line passes nearest to a pixel, within `reach` pixels; -1 for none.
    int bridge_at(const Pixel& pixel, double reach) const;

    // Orbit, pan and zoom by the movement of the mouse in pixels.
    void drag_orbit(const Pixel& from, const Pixel& to);
    void drag_pan(const Pixel& from, const Pixel& to);
    void zoom_by(double factor);
    // To the right and down [degrees], as drag_orbit() does.
    void turn_by(double right_deg, double down_deg);
    // All of the tree from where it is looked at now.
    void show_whole();

  private:
    void keep_in_sight();
    // How many of the surface's vertices appear in each of the boxes.
    std::vector<int> vertices_within(const std::vector<PictureBox>& boxes) const;

    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace hepatica
