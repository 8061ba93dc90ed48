// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/scene_view.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkPlane.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "render/palette.h"
#include "render/scene_view_parts.h"

namespace hepatica {
namespace {

using std::numbers::pi;

constexpr double halo_points = 2.5;     // width on the screen
constexpr double halo_behind_mm = 1.5;  // shift behind its vessel, so that bends show none

vtkSmartPointer<vtkLight> add_light(vtkRenderer& renderer, const Vec3& from, const Colour& colour,
                                    double intensity) {
    auto light = vtkSmartPointer<vtkLight>::New();
    light->SetLightTypeToCameraLight();
    light->SetPosition(from.x(), from.y(), from.z());
    light->SetFocalPoint(0, 0, 0);
    light->SetColor(colour[0], colour[1], colour[2]);
    light->SetIntensity(intensity);
    renderer.AddLight(light);
    return light;
}

}  // namespace

SceneView::SceneView(vtkRenderWindow& window) : parts_(std::make_unique<Parts>(window)) {
    vtkRenderer& renderer = *parts_->renderer;
    renderer.SetGradientBackground(true);
    set_look(dark_look);
    parts_->find_colours_shown();
    renderer.AutomaticLightCreationOff();
    // Three lights that move with the camera: a warm one from the upper left, a cooler and weaker
    // one from the right, and a weak one from below, which keeps undersides visible and is on only
    // for `best`.
    add_light(renderer, {-0.6, 0.9, 1.0}, {1.0, 0.98, 0.95}, 0.85);
    add_light(renderer, {1.0, 0.1, 0.8}, {0.80, 0.88, 1.0}, 0.35);
    parts_->light_from_below = add_light(renderer, {-0.2, -1.0, 0.4}, {0.9, 0.85, 1.0}, 0.18);
    for (vtkActor* actor : parts_->tree.actors()) renderer.AddActor(actor);
    renderer.AddActor(parts_->tree.halo().actor());
    renderer.AddActor(parts_->liver.actor());
    renderer.AddActor(parts_->tumours.actor());
    renderer.AddActor(parts_->grab.line());
    renderer.AddActor(parts_->grab.point());
    renderer.AddActor(parts_->crosshair.actor());
    for (vtkActor* actor : parts_->weak_lines.actors()) renderer.AddActor(actor);
    window.AddRenderer(&renderer);
    hepatica::look_from(*renderer.GetActiveCamera(), ViewDirection::anterior, Vec3::Constant(-50),
                        Vec3::Constant(50), 1.0);
}

SceneView::~SceneView() {
    parts_->window.RemoveRenderer(parts_->renderer);
}

bool SceneView::show(const Frame& frame) {
    const LegendContent explained = parts_->legend;
    const bool tree_changed = parts_->tree.update(frame);
    const bool pull_changed = parts_->grab.update(frame.grab);
    const bool tool_changed = parts_->tool.update(frame.tool, frame.positions_mm);
    const bool obstacles_changed = parts_->obstacles.update(frame.obstacles);
    if (obstacles_changed) {
        parts_->fit_wall_to_liver();
        parts_->fit_tumours_to_obstacles();
    }
    const bool lines_changed = parts_->weak_lines.update(frame);
    const bool stem_changed = parts_->lead_stem();
    const GrabView pull = frame.grab.value_or(GrabView{});
    const std::string pull_force = said(parts_->words, force_text(pull.shown_un()));
    const bool force_changed = parts_->pull_force.show(pull_force, pull.target_mm);
    const bool blood_changed = parts_->bleeding.update(frame.tear);
    set_frame_shown(parts_->legend, frame, parts_->warned, parts_->least_drug_end_s);
    parts_->legend.stretched = parts_->tree.shows_stretch();
    parts_->legend.bleeds &= parts_->blood_shown;
    if (frame.drug.arrival_s || parts_->drug.arrival_s) {
        parts_->drug = frame.drug;
        parts_->find_colours_shown();
    }
    if (parts_->tree.surface().triangles().empty()) parts_->looked = false;
    if (!parts_->looked && !parts_->tree.surface().triangles().empty())
        look_from(ViewDirection::anterior);
    return tree_changed || pull_changed || tool_changed || obstacles_changed || lines_changed ||
           stem_changed || force_changed || blood_changed || parts_->legend != explained;
}

void SceneView::render(double pixel_ratio) {
    parts_->pixel_ratio = pixel_ratio;
    keep_in_sight();
    vtkRenderer& renderer = *parts_->renderer;
    vtkCamera& eye = camera();
    const SurfaceGeometry& surface = parts_->tree.surface();
    if (!surface.triangles().empty()) {
        const double distance = eye.GetDistance();
        const double reach = 0.5 * (surface.upper_mm() - surface.lower_mm()).norm();
        parts_->tree.set_fade(distance - 0.35 * reach, distance + 1.1 * reach);
        const int height = parts_->picture_size().height;
        const double per_pixel =
            height > 0 ? 2.0 * distance * std::tan(0.5 * eye.GetViewAngle() * pi / 180.0) / height
                       : 1.0 / pixel_ratio;
        parts_->grab.set_scale(per_pixel * pixel_ratio, pixel_ratio);
        // The body lies around the focal point, or panning has moved it by no more than its size.
        parts_->marks.set_scale(per_pixel * pixel_ratio, pixel_ratio, 2.0 * reach);
        parts_->tool.set_scale(per_pixel * pixel_ratio, pixel_ratio);
        parts_->place_stem();
        parts_->pull_force.place(pixel_ratio);
        parts_->weak_lines.set_place(-Vec3(eye.GetDirectionOfProjection()),
                                     per_pixel * pixel_ratio);
        parts_->tree.halo().set_place(halo_points * pixel_ratio * per_pixel / distance,
                                      halo_behind_mm * Vec3(eye.GetDirectionOfProjection()));
        parts_->tree.halo().set_background(parts_->look.top, parts_->look.bottom, height);
    }
    const MeasureMarks::Place place =
        [projection = parts_->projection(), height = parts_->picture_size().height](
            const Vec3& position_mm) -> std::optional<std::array<double, 2>> {
        if (!projection.sees(position_mm)) return std::nullopt;
        const Pixel pixel = projection.pixel_of(position_mm);
        return std::array{pixel.x, height - pixel.y};
    };
    parts_->stroke.update(place, pixel_ratio);
    parts_->bridges.set_pixel_ratio(pixel_ratio);
    parts_->crosshair.set_pixel_ratio(pixel_ratio);
    parts_->prepare_volume();
    renderer.ResetCameraClippingRange();
    parts_->annotations.set_visible(parts_->annotated && !surface.triangles().empty());
    parts_->orientation.set_visible(parts_->annotated && !surface.triangles().empty());
    // While the scene moves the legend keeps its corner, unless a new view was chosen.
    parts_->annotations.update(
        parts_->picture_size(), eye, parts_->legend,
        std::exchange(parts_->turned, false) || (parts_->at_rest && !parts_->moving)
            ? [this](const std::vector<PictureBox>& boxes) { return vertices_within(boxes); }
            : Legend::Count());
    parts_->chosen_branch.update(place, pixel_ratio);
    // After the legend, on which no value must lie.
    parts_->measures.update(place, pixel_ratio, parts_->picture_size().covered_top,
                            parts_->picture_size().covered_bottom,
                            parts_->annotations.legend_box());
    parts_->orientation.update(eye, parts_->picture_size());
    parts_->window.Render();
}

void SceneView::set_vertex_systems(std::vector<VascularSystem> systems) {
    parts_->systems = systems;
    parts_->find_colours_shown();
    parts_->tree.set_vertex_systems(std::move(systems));
}

void SceneView::set_vertex_segments(std::vector<std::uint8_t> segments) {
    parts_->segments = segments;
    parts_->find_colours_shown();
    parts_->tree.set_vertex_segments(std::move(segments));
}

void SceneView::set_highlight(std::vector<std::uint8_t> vertices, HighlightOf what) {
    parts_->tree.set_highlight(std::move(vertices), what == HighlightOf::branch);
    parts_->legend.lit_branch = what == HighlightOf::branch;
    parts_->find_highlights_shown();
}

bool SceneView::set_chosen_branch(std::vector<Vec3> line_mm) {
    parts_->legend.branch_line = !line_mm.empty();
    std::vector<MeasureView> line;
    if (!line_mm.empty()) line.push_back({std::move(line_mm), ""});
    return parts_->chosen_branch.show(std::move(line));
}

void SceneView::set_target(std::vector<std::uint8_t> vertices) {
    parts_->tree.set_target(std::move(vertices));
    parts_->find_highlights_shown();
}

const std::vector<std::uint8_t>& SceneView::target() const {
    return parts_->tree.target();
}

const LegendContent& SceneView::legend() const {
    return parts_->legend;
}

const std::vector<std::uint8_t>& SceneView::highlight() const {
    return parts_->tree.highlight();
}

void SceneView::set_stroke(const std::optional<std::array<Vec3, 2>>& stroke) {
    parts_->stroke.show(stroke);
}

bool SceneView::set_crosshair(const std::optional<Vec3>& position_mm) {
    return parts_->crosshair.show(position_mm);
}

bool SceneView::set_marks(std::vector<MarkView> marks) {
    const auto any_place = [&](bool reached) {
        return std::ranges::any_of(marks, [reached](const MarkView& mark) {
            return mark.of_lesson && mark.reached == reached;
        });
    };
    parts_->legend.places = any_place(false);
    parts_->legend.places_reached = any_place(true);
    if (!parts_->marks.update(std::move(marks))) return false;
    parts_->lead_stem();
    return true;
}

const std::vector<MarkView>& SceneView::marks() const {
    return parts_->marks.shown();
}

std::optional<Vec3> SceneView::mark_at(const Pixel& pixel, double times) const {
    return parts_->marks.place_at(parts_->projection(), pixel, times);
}

bool SceneView::set_measures(std::vector<MeasureView> measures) {
    return parts_->measures.show(std::move(measures));
}

const std::vector<MeasureView>& SceneView::measures() const {
    return parts_->measures.shown();
}

const std::vector<PictureBox>& SceneView::measure_labels() const {
    return parts_->measures.labels();
}

std::vector<PictureBox> SceneView::tool_labels() const {
    std::vector<PictureBox> labels;
    for (const auto& box : {parts_->tool.label_box(), parts_->stem.label_box()})
        if (box) labels.push_back(*box);
    return labels;
}

void SceneView::set_halos_visible(bool visible) {
    parts_->tree.set_halo(visible);
}

void SceneView::set_bridges(std::vector<BridgeView> bridges) {
    parts_->legend.gaps = !bridges.empty();
    parts_->bridges.set_bridges(std::move(bridges));
}
void SceneView::set_liver(const TriangleMesh& surface) {
    parts_->liver.set_surface(surface);
    parts_->fit_wall_to_liver();
}
void SceneView::set_liver_visible(bool visible) {
    parts_->liver.set_visible(visible);
    parts_->fit_wall_to_liver();
}
void SceneView::set_tumours(const TriangleMesh& surface) {
    parts_->all_tumours = surface;
    parts_->fit_tumours_to_obstacles();
}
void SceneView::set_volume(std::shared_ptr<const Volume> ct) {
    parts_->volume.show(std::move(ct));
}
bool SceneView::set_volume_look(const VolumeLook& look) {
    return parts_->volume.set_look(look);
}

void SceneView::set_clip(const std::optional<ClipPlane>& plane) {
    parts_->clip = plane;
    if (plane) {
        parts_->clip_plane->SetOrigin(plane->point_mm.x(), plane->point_mm.y(),
                                      plane->point_mm.z());
        parts_->clip_plane->SetNormal(plane->inward.x(), plane->inward.y(), plane->inward.z());
    }
    vtkPlane* drawn = plane ? parts_->clip_plane.Get() : nullptr;
    parts_->tree.set_clip(drawn);
    parts_->liver.set_clip(drawn);
    parts_->tumours.set_clip(drawn);
    parts_->obstacles.set_clip(drawn);
    parts_->bleeding.set_clip(drawn);
    parts_->volume.set_clip(drawn);
}

void SceneView::set_look(const ViewLook& look) {
    parts_->look = look;
    parts_->renderer->SetBackground(look.bottom[0], look.bottom[1], look.bottom[2]);
    parts_->renderer->SetBackground2(look.top[0], look.top[1], look.top[2]);
    parts_->tree.set_distance(look.distance);
    parts_->tree.set_bright(look.bright_vessels);
    parts_->legend.bright = look.bright_vessels;
    parts_->annotations.set_look(look);
    parts_->volume.set_room(look);
    parts_->measures.set_colours(look.measure, look.bottom);
    parts_->chosen_branch.set_colours(palette::chosen_branch(look.bright_vessels), look.bottom);
    parts_->bridges.set_text_colour(look.text);
    parts_->marks.set_text_colour(look.text);
    parts_->tool.set_colour(look.tool);
    parts_->stem.set_colour(look.tool);
}

void SceneView::set_words(const PictureWords& words) {
    parts_->annotations.set_words(words);
    parts_->bridges.set_words(words);
    parts_->tool.set_words(words);
    parts_->stem.set_words(words);
    parts_->words = words;
}

bool SceneView::set_caption(const std::string& text) {
    return parts_->annotations.set_caption(text);
}

void SceneView::set_annotations_visible(bool visible) {
    parts_->annotated = visible;
}

bool SceneView::set_covered(int top, int bottom) {
    const std::array<int, 2> now{top, bottom};
    if (std::exchange(parts_->covered, now) == now) return false;
    parts_->turned = true;  // the legend may move at once
    return true;
}

void SceneView::set_drug_scale(double least_end_s) {
    parts_->tree.set_drug_scale(least_end_s);
    parts_->least_drug_end_s = least_end_s;
}

void SceneView::set_warnings_visible(bool visible) {
    parts_->warned = visible;
    if (!visible) parts_->legend.warned = false;
    parts_->tree.set_warnings(visible);
}

void SceneView::set_stretch_visible(bool visible) {
    parts_->tree.set_stretch_shown(visible);
    if (!visible) parts_->legend.stretched = false;
}

void SceneView::set_blood_visible(bool visible) {
    parts_->bleeding.set_visible(visible);
    parts_->blood_shown = visible;
}

void SceneView::set_rest_positions(const std::vector<Vec3>& rest_mm) {
    parts_->tree.set_rest_positions(rest_mm);
}

void SceneView::set_smoothing(Smoothing smoothing) {
    parts_->window.SetMultiSamples(smoothing == Smoothing::best ? 8 : 0);
    parts_->renderer->SetUseFXAA(smoothing == Smoothing::cheap);
    parts_->light_from_below->SetSwitch(smoothing == Smoothing::best);
    parts_->at_rest = smoothing != Smoothing::none;
    parts_->tree.set_rounded(parts_->at_rest);
    parts_->volume.set_detail(smoothing == Smoothing::none    ? VolumeDetail::coarse
                              : smoothing == Smoothing::cheap ? VolumeDetail::fine
                                                              : VolumeDetail::best);
}

void SceneView::set_moving(bool moving) {
    parts_->moving = moving;
}

bool SceneView::shows_caption() const {
    return parts_->annotations.shows_caption();
}

PictureBox SceneView::legend_box() const {
    return parts_->annotations.legend_box();
}

}  // namespace hepatica
