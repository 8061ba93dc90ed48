// SPDX-License-Identifier: GPL-3.0-or-later
// What all slices show at once: the CT, the vessels' voxels and centrelines in it, the place of the
// crosshair, and how grey and how opaque. No widget.
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
#include "ui/slices/tumour_brush.h"
#include "ui/slices/vessel_pen.h"

namespace hepatica {

// How a piece of the centrelines crosses a slice.
struct CentrelinePoint {
    Vec3 position_mm = Vec3::Zero();
    double radius_mm = 0.0;
    VascularSystem system = VascularSystem::unknown;
};

// UI thread.
class SliceScene {
  public:
    SliceScene();
    // Whenever anything below was changed.
    void on_change(std::function<void()> tell) { watchers_.push_back(std::move(tell)); }

    // The crosshair comes to the middle of the tree.
    void show(std::shared_ptr<const Volume> ct, Mask systems, const VesselTree& tree);
    // The same CT with a corrected tree.
    void show_tree(const VesselTree& tree);
    void clear();

    // Counts the changes of all that a slice shows but the crosshair, its centrelines and marks.
    std::uint64_t voxels_version() const { return voxels_version_; }

    bool empty() const { return ct_ == nullptr; }
    const Volume& ct() const { return *ct_; }  // unless empty
    const std::shared_ptr<const Volume>& shared_ct() const { return ct_; }
    // The vessels' voxels with what is erased by hand, and what is painted as painted_label.
    const Mask& systems() const { return systems_; }
    // Counts their changes.
    std::uint64_t systems_version() const { return systems_version_; }
    // What the slices show instead while a choice is tried out, and which becomes the vessels where
    // the person says so; empty: nothing is tried.
    void set_preview(Mask systems);
    const Mask& preview() const { return preview_; }
    const Mask& shown_systems() const { return preview_.voxels.empty() ? systems_ : preview_; }
    // What is shown, with what is painted or found anew as vessels of an unknown system.
    Mask vessels() const;
    // The same with what the brush painted as painted_voxel (core/reconstruction/remade_case.h).
    Mask painted_vessels() const { return preview_.voxels.empty() ? systems_ : vessels(); }
    // Others, of the same patient: what is painted is painted on them. Nothing changes where they
    // are those before.
    void set_systems(Mask systems);
    std::vector<CentrelinePoint> const& centrelines() const { return centrelines_; }
    const VesselTree& tree() const { return tree_; }
    // They go with the patient, and have watchers of their own.
    Measurements& measurements() { return measurements_; }
    const Measurements& measurements() const { return measurements_; }
    // Likewise.
    VesselPen& pen() { return pen_; }
    const VesselPen& pen() const { return pen_; }
    // Likewise.
    MaskBrush& brush() { return brush_; }
    const MaskBrush& brush() const { return brush_; }
    // Likewise; its ball is as large as that of the other.
    TumourBrush& tumours() { return tumours_; }
    const TumourBrush& tumours() const { return tumours_; }

    // Of whichever brush is in hand. Putting down and lifting say why nothing is left; empty: all
    // is well.
    bool brushing() const;
    bool brush_erases() const;
    std::string put_brush_down(const Vec3& position_mm);
    void lead_brush_to(const Vec3& position_mm);
    std::string lift_brush();
    void take_last_stroke_back();
    // Takes all strokes back; where there are none, puts the brush away.
    void give_up_brush();

    // Whether a click in a slice corrects the vessel there, as the panel of corrections says.
    bool corrects() const { return corrects_; }
    void set_corrects(bool corrects);

    const Vec3& crosshair_mm() const { return crosshair_mm_; }
    // Outside of the CT it stays at its border.
    void set_crosshair(const Vec3& position_mm);
    const GreyWindow& window() const { return window_; }
    void set_window(const GreyWindow& window);   // a width below 1 HU counts as 1
    double opacity() const { return opacity_; }  // of the vessels' voxels, 0 to 1
    void set_opacity(double opacity);
    // Couinaud's, 1 to 8, on a grid of their own; empty: none, for the reason given.
    void set_segments(Mask segments, std::string why_none);
    const Mask& segments() const { return segments_; }
    const std::string& why_no_segments() const { return why_no_segments_; }
    bool shows_segments() const { return shows_segments_ && !segments_.voxels.empty(); }
    void set_segments_visible(bool visible);
    bool shows_centrelines() const { return shows_centrelines_; }
    void set_centrelines_visible(bool visible);

    // Of a place: its coordinates, its Hounsfield units, the segment of the liver and the vessel
    // there; empty outside.
    std::string describe(const Vec3& position_mm) const;

  private:
    void tell() const;
    void tell_of_voxels();
    // Brings the voxels up to the strokes: the last one's new piece, or all of them anew.
    void follow_brush();
    // Those of another patient.
    void forget_strokes();
    // The voxels are others, without any of the strokes.
    void paint_anew();
    bool brushing_tumours() const { return tumours_.mode() != BrushMode::away; }
    // Why a brush leaves nothing of vessels at this place; empty: it does.
    std::string why_not_painted(const Vec3& position_mm) const;
    int segment_at(const Vec3& position_mm) const;  // 0: none

    std::shared_ptr<const Volume> ct_;
    Mask systems_;
    Mask preview_;
    Mask unpainted_;  // systems_ before the first stroke; empty: there is none
    // Of the strokes that systems_ shows: how many, and points of the last.
    std::size_t shown_strokes_ = 0, shown_points_ = 0;
    Mask segments_;
    std::string why_no_segments_;
    std::vector<CentrelinePoint> centrelines_;
    VesselTree tree_;
    Measurements measurements_;
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
    std::vector<std::function<void()>> watchers_;
};

}  // namespace hepatica
