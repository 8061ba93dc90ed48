// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slices/slice_scene.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/tree/territories/segment_name.h"
#include "ui/core_words.h"
#include "ui/patient_place.h"
#include "ui/words.h"

namespace hepatica {
namespace {

std::vector<CentrelinePoint> centrelines_of(const VesselTree& tree) {
    std::vector<CentrelinePoint> points;
    int branch = 0;
    for (const VesselSegment& segment : tree.segments) {
        for (std::size_t i = 0; i < segment.points_mm.size(); ++i)
            points.push_back({segment.points_mm[i], segment.radii_mm[i], segment.system, branch});
        ++branch;
    }
    return points;
}

}  // namespace

SliceScene::SliceScene() {
    brush_.on_change([this] { follow_brush(); });
    tumours_.on_change([this] { tell_of_voxels(); });
}

void SliceScene::show(std::shared_ptr<const Volume> ct, Mask systems, const VesselTree& tree) {
    ct_ = std::move(ct);
    systems_ = std::move(systems);
    ++systems_version_;
    preview_ = {};
    forget_strokes();
    tree_ = tree;
    centrelines_ = centrelines_of(tree);
    Vec3 middle = ct_->grid.to_mm(
        0.5 * Vec3(ct_->grid.dims[0] - 1, ct_->grid.dims[1] - 1, ct_->grid.dims[2] - 1));
    if (!centrelines_.empty()) {
        // The thickest point lies in a vessel for certain, unlike the mean of all points.
        const auto thickest =
            std::ranges::max_element(centrelines_, {}, &CentrelinePoint::radius_mm);
        middle = thickest->position_mm;
    }
    ++voxels_version_;
    set_crosshair(middle);
}

void SliceScene::show_tree(const VesselTree& tree) {
    tree_ = tree;
    centrelines_ = centrelines_of(tree);
    tell_of_voxels();
}

void SliceScene::set_systems(Mask systems) {
    const Mask& before = brush_.strokes().empty() ? systems_ : unpainted_;
    if (systems.voxels == before.voxels) return;
    systems_ = std::move(systems);
    ++systems_version_;
    preview_ = {};
    paint_anew();
    tell_of_voxels();
}

// The strokes of the former patient were painted on other voxels.
void SliceScene::forget_strokes() {
    unpainted_ = {};
    shown_strokes_ = shown_points_ = 0;
    brush_.show({});
}

void SliceScene::paint_anew() {
    unpainted_ = {};
    shown_strokes_ = shown_points_ = 0;
    follow_brush();
}

// A stroke that grew by one point is painted onto the present voxels; after any other change all
// strokes are painted again.
void SliceScene::follow_brush() {
    const std::vector<BrushStroke>& strokes = brush_.strokes();
    const std::size_t points = strokes.empty() ? 0 : strokes.back().path_mm.size();
    if (strokes.size() == shown_strokes_ && points == shown_points_) return watchers_.tell();
    const bool led_on = strokes.size() == shown_strokes_ && points == shown_points_ + 1;
    if (led_on) {
        const BrushStroke& last = strokes.back();
        leave({{last.path_mm.end()[-2], last.path_mm.back()}, last.radius_mm, last.erases});
    } else {
        if (unpainted_.voxels.empty()) unpainted_ = systems_;
        systems_ = unpainted_;
        for (const BrushStroke& stroke : strokes) {
            led_erased_ = 0;
            leave(stroke);
        }
        if (strokes.empty()) unpainted_ = {};
    }
    shown_strokes_ = strokes.size();
    shown_points_ = points;
    ++systems_version_;
    preview_ = {};  // it was made from the voxels before this stroke
    tell_of_voxels();
}

void SliceScene::leave(const BrushStroke& stroke) {
    if (stroke.erases)
        sweep(stroke, systems_.grid,
              [this](std::size_t voxel) { led_erased_ += systems_.voxels[voxel] != 0 ? 1 : 0; });
    apply(stroke, painted_label, systems_);
}

std::string SliceScene::why_not_painted(const Vec3& position_mm) const {
    if (systems_.voxels.empty())
        return Words::tr("This case knows no voxels of its vessels").toStdString();
    if (!holds(systems_.grid, position_mm))
        return Words::tr("Too far from the liver: the vessels' voxels end before").toStdString();
    return {};
}

void SliceScene::set_preview(Mask systems) {
    if (systems.voxels.empty() && preview_.voxels.empty()) return;
    preview_ = std::move(systems);
    tell_of_voxels();
}

bool SliceScene::brushing() const {
    return brush_.mode() != BrushMode::away || brushing_tumours();
}

bool SliceScene::brush_erases() const {
    return (brushing_tumours() ? tumours_.mode() : brush_.mode()) == BrushMode::erases;
}

std::string SliceScene::put_brush_down(const Vec3& position_mm) {
    std::string why_not =
        brushing_tumours() ? tumours_.why_not_painted(position_mm) : why_not_painted(position_mm);
    if (!why_not.empty()) return why_not;
    if (brushing_tumours())
        tumours_.begin(position_mm, brush_.radius_mm());
    else
        brush_.begin(position_mm);
    return {};
}

void SliceScene::lead_brush_to(const Vec3& position_mm) {
    if (brushing_tumours())
        tumours_.lead_to(position_mm);
    else
        brush_.lead_to(position_mm);
}

// A stroke that erased nothing would be a step of undo that does nothing.
std::string SliceScene::lift_brush() {
    if (brush_.leads() && brush_.strokes().back().erases && led_erased_ == 0) {
        brush_.remove_last();
        return Words::tr("Nothing erased: there is no vessel").toStdString();
    }
    brush_.lift();
    return tumours_.lift();
}

void SliceScene::take_last_stroke_back() {
    if (brushing_tumours())
        tumours_.remove_last();
    else
        brush_.remove_last();
}

void SliceScene::give_up_brush() {
    if (brushing_tumours())
        tumours_.give_up();
    else
        brush_.strokes().empty() ? brush_.set_mode(BrushMode::away) : brush_.remove_all();
}

bool SliceScene::points_wait() const {
    return !pen_.places_mm().empty() || measurements_.half_made() != nullptr;
}

void SliceScene::take_last_point_back() {
    if (measurements_.half_made() != nullptr)
        measurements_.remove_last();
    else if (pen_.draws())
        pen_.give_up();
    else
        pen_.remove_last();
}

Mask SliceScene::vessels() const {
    Mask vessels = shown_systems();
    std::ranges::replace(vessels.voxels, painted_label,
                         static_cast<std::uint8_t>(number_of(VascularSystem::unknown)));
    return vessels;
}

void SliceScene::clear() {
    ct_.reset();
    systems_ = {};
    ++systems_version_;
    preview_ = {};
    forget_strokes();
    brush_.set_mode(BrushMode::away);
    tumours_.show_none({});  // first, so that an unfinished stroke does not go to the next patient
    tumours_.set_mode(BrushMode::away);
    segments_ = {};
    why_no_segments_.clear();
    tree_ = {};
    centrelines_.clear();
    pointed_out_.clear();
    measurements_.clear();
    corrects_ = false;
    pen_.set_taken(false);
    seeds_.clear();
    tell_of_voxels();
}

void SliceScene::set_crosshair(const Vec3& position_mm) {
    if (empty()) return;
    Vec3 index = ct_->grid.to_index(position_mm);
    for (int i = 0; i < 3; ++i)
        index[i] = std::clamp(index[i], 0.0,
                              static_cast<double>(ct_->grid.dims[static_cast<std::size_t>(i)] - 1));
    crosshair_mm_ = ct_->grid.to_mm(index);
    watchers_.tell();
}

void SliceScene::point_out(std::vector<Vec3> path_mm) {
    if (pointed_out_ == path_mm) return;
    pointed_out_ = std::move(path_mm);
    watchers_.tell();
}

void SliceScene::set_window(const GreyWindow& window) {
    window_ = {window.level_hu, std::max(1.0, window.width_hu)};
    tell_of_voxels();
}

void SliceScene::set_opacity(double opacity) {
    opacity_ = std::clamp(opacity, 0.0, 1.0);
    tell_of_voxels();
}

void SliceScene::set_segments(Mask segments, std::string why_none) {
    segments_ = std::move(segments);
    why_no_segments_ = std::move(why_none);
    tell_of_voxels();
}

void SliceScene::set_segments_visible(bool visible) {
    shows_segments_ = visible;
    tell_of_voxels();
}

void SliceScene::set_corrects(bool corrects) {
    corrects_ = corrects;
    watchers_.tell();
}

void SliceScene::set_centrelines_visible(bool visible) {
    shows_centrelines_ = visible;
    watchers_.tell();
}

int SliceScene::segment_at(const Vec3& position_mm) const {
    return segments_.voxels.empty() ? 0 : value_at(segments_, position_mm);
}

bool SliceScene::supplies_several(const CentrelinePoint& vessel) const {
    if (vessel.system != VascularSystem::portal) return false;
    // Parents stand before their children.
    std::vector<std::uint8_t> beyond(tree_.segments.size(), 0), passed_on(beyond);
    beyond[static_cast<std::size_t>(vessel.branch)] = 1;
    for (std::size_t s = 0; s < beyond.size(); ++s) {
        const int parent = tree_.segments[s].parent;
        if (parent < 0 || beyond[static_cast<std::size_t>(parent)] == 0) continue;
        beyond[s] = passed_on[static_cast<std::size_t>(parent)] = 1;
    }
    std::set<int> supplied;
    for (std::size_t s = 0; s < beyond.size(); ++s)
        if (beyond[s] != 0 && passed_on[s] == 0)
            if (const int segment = segment_at(tree_.segments[s].points_mm.back()); segment > 0)
                supplied.insert(segment);
    return supplied.size() > 1;
}

const CentrelinePoint* SliceScene::vessel_at(const Vec3& position_mm) const {
    const CentrelinePoint* vessel = nullptr;
    double nearest = 1.0;  // distance in radii
    for (const CentrelinePoint& point : centrelines_) {
        const double radii = (point.position_mm - position_mm).norm() / point.radius_mm;
        if (radii > nearest) continue;
        nearest = radii;
        vessel = &point;
    }
    return vessel;
}

std::string SliceScene::describe(const Vec3& position_mm) const {
    if (empty()) return {};
    if (!holds(ct_->grid, position_mm)) return {};
    std::string text = patient_place(position_mm, 1).toStdString() + "   " +
                       std::to_string(value_at(*ct_, position_mm)) + " HU";
    const CentrelinePoint* vessel = vessel_at(position_mm);
    const int segment = segment_at(position_mm);
    if (segment > 0 && !(vessel && supplies_several(*vessel)))
        text += "   " + Words::tr("liver segment %1")
                            .arg(QString::fromStdString(segment_name(segment)))
                            .toStdString();
    if (const int tumour = tumours_.tumour_at(position_mm); tumour > 0)
        text += "   " + Words::tr("tumour %1").arg(tumour).toStdString();
    if (!vessel) return text;
    return text + "   " +
           Words::tr("%1, radius %L2 mm")
               .arg(translated(title_of(vessel->system)))
               .arg(vessel->radius_mm, 0, 'f', 1)
               .toStdString();
}

void SliceScene::tell_of_voxels() {
    ++voxels_version_;
    watchers_.tell();
}

}  // namespace hepatica
