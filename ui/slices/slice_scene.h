// SPDX-License-Identifier: GPL-3.0-or-later
// State shared by all slice views: CT, vessel voxels and centrelines, crosshair, grey window and
// opacity, and the tools for measuring, drawing and painting. No widgets.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/image/slice.h"
#include "core/tree/vessel_tree.h"
#include "ui/slices/mask_brush.h"
#include "ui/slices/measurements.h"
#include "ui/slices/seed_marks.h"
#include "ui/slices/tumour_brush.h"
#include "ui/slices/vessel_pen.h"
#include "ui/slices/watchers.h"

namespace hepatica {

// A point of a centreline.
struct CentrelinePoint {
    Vec3 position_mm = Vec3::Zero();
    double radius_mm = 0.0;
    VascularSystem system = VascularSystem::unknown;
    int branch = -1;  // segment of the tree
};

// UI thread only.
class SliceScene {
  public:
    SliceScene();
    // Called after every change.
    void on_change(std::function<void()> tell) { watchers_.add(std::move(tell)); }

    // Shows another patient. The crosshair moves to the thickest point of the centrelines, or to
    // the middle of the CT if there is none.
    void show(std::shared_ptr<const Volume> ct, Mask systems, const VesselTree& tree);
    // The same CT with a corrected tree; removes the diameters measured in the former one.
    void show_tree(const VesselTree& tree);
    void clear();

    // Counts the changes of all that is drawn from voxels: not those of crosshair, centrelines and
    // marks alone.
    std::uint64_t voxels_version() const { return voxels_version_; }

    bool empty() const { return ct_ == nullptr; }
    const Volume& ct() const { return *ct_; }  // not if empty()
    const std::shared_ptr<const Volume>& shared_ct() const { return ct_; }
    // The vessel voxels, labelled by vascular system; erased ones are 0 and painted ones
    // painted_label.
    const Mask& systems() const { return systems_; }
    // Counts the changes of systems().
    std::uint64_t systems_version() const { return systems_version_; }
    // Voxels shown instead of systems() while a threshold is tried out; empty: none.
    void set_preview(Mask systems);
    const Mask& preview() const { return preview_; }
    const Mask& shown_systems() const { return preview_.voxels.empty() ? systems_ : preview_; }
    // The shown voxels, with painted or newly found ones as vessels of unknown system.
    Mask vessels() const;
    // The same with what the brush painted as painted_voxel (core/reconstruction/remade_case.h).
    Mask painted_vessels() const { return preview_.voxels.empty() ? systems_ : vessels(); }
    // Other voxels of the same patient; the strokes are painted onto them again. No effect if they
    // equal the present ones.
    void set_systems(Mask systems);
    std::vector<CentrelinePoint> const& centrelines() const { return centrelines_; }
    const VesselTree& tree() const { return tree_; }
    // The tools below are reset with the patient and have watchers of their own.
    Measurements& measurements() { return measurements_; }
    const Measurements& measurements() const { return measurements_; }
    SeedMarks& seeds() { return seeds_; }
    const SeedMarks& seeds() const { return seeds_; }
    VesselPen& pen() { return pen_; }
    const VesselPen& pen() const { return pen_; }
    MaskBrush& brush() { return brush_; }
    const MaskBrush& brush() const { return brush_; }
    // Uses the radius of brush().
    TumourBrush& tumours() { return tumours_; }
    const TumourBrush& tumours() const { return tumours_; }

    // The functions below act on the brush in use, for tumours or vessels. put_brush_down() and
    // lift_brush() return why nothing was painted; empty if all is well.
    bool brushing() const;
    bool brush_erases() const;
    std::string put_brush_down(const Vec3& position_mm);
    void lead_brush_to(const Vec3& position_mm);
    std::string lift_brush();
    void take_last_stroke_back();
    // Takes all strokes back; if there are none, puts the brush away.
    void give_up_brush();

    // Whether points wait for the vessel or the measurement that is to be made of them. Undo takes
    // the last of them back before any correction, or stops the drawing of their vessel.
    bool points_wait() const;
    void take_last_point_back();

    // Whether a click in a slice corrects the vessel there, as chosen in the panel of corrections.
    bool corrects() const { return corrects_; }
    void set_corrects(bool corrects);

    const Vec3& crosshair_mm() const { return crosshair_mm_; }
    // Clamped to the CT. No effect without a CT.
    void set_crosshair(const Vec3& position_mm);
    // A path that somebody decides on, drawn as a line; empty: none.
    void point_out(std::vector<Vec3> path_mm);
    const std::vector<Vec3>& pointed_out() const { return pointed_out_; }
    const GreyWindow& window() const { return window_; }
    void set_window(const GreyWindow& window);   // a width below 1 HU counts as 1
    double opacity() const { return opacity_; }  // of the vessel voxels, clamped to 0 to 1
    void set_opacity(double opacity);
    // Couinaud segments, labels 1 to 8, on a grid of their own; if empty, `why_none` tells why.
    void set_segments(Mask segments, std::string why_none);
    const Mask& segments() const { return segments_; }
    const std::string& why_no_segments() const { return why_no_segments_; }
    bool shows_segments() const { return shows_segments_ && !segments_.voxels.empty(); }
    void set_segments_visible(bool visible);
    bool shows_centrelines() const { return shows_centrelines_; }
    void set_centrelines_visible(bool visible);

    // Coordinates, Hounsfield units, liver segment, tumour and vessel at this place, in words;
    // empty outside of the CT.
    std::string describe(const Vec3& position_mm) const;
    int segment_at(const Vec3& position_mm) const;  // 0 if none

  private:
    // A trunk or main branch of the portal vein, which is no segment's own.
    bool supplies_several(const CentrelinePoint& vessel) const;
    // The vessel whose lumen the place is in; null: none.
    const CentrelinePoint* vessel_at(const Vec3& position_mm) const;
    void tell_of_voxels();
    // Applies a stroke, or the new piece of one, to the voxels.
    void leave(const BrushStroke& stroke);
    // Brings the voxels up to date with the strokes.
    void follow_brush();
    // For another patient.
    void forget_strokes();
    // Paints the strokes onto other voxels.
    void paint_anew();
    bool brushing_tumours() const { return tumours_.mode() != BrushMode::away; }
    // Why the vessel brush cannot paint at this place; empty if it can.
    std::string why_not_painted(const Vec3& position_mm) const;

    std::shared_ptr<const Volume> ct_;
    Mask systems_;
    Mask preview_;
    Mask unpainted_;  // systems_ before the first stroke; empty if there is none
    // Number of strokes in systems_, and of points of the last one.
    std::size_t shown_strokes_ = 0, shown_points_ = 0;
    std::size_t led_erased_ = 0;  // voxels of vessels that the last stroke erased
    Mask segments_;
    std::string why_no_segments_;
    std::vector<CentrelinePoint> centrelines_;
    std::vector<Vec3> pointed_out_;
    VesselTree tree_;
    Measurements measurements_;
    SeedMarks seeds_;
    VesselPen pen_;
    MaskBrush brush_;
    TumourBrush tumours_;
    Vec3 crosshair_mm_ = Vec3::Zero();
    GreyWindow window_{};
    double opacity_ = 0.6;
    bool shows_segments_ = false;
    bool shows_centrelines_ = true;
    bool corrects_ = false;
    std::uint64_t voxels_version_ = 0;
    std::uint64_t systems_version_ = 0;
    Watchers watchers_;
};

}  // namespace hepatica
