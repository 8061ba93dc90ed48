// SPDX-License-Identifier: GPL-3.0-or-later
// The middle of the window: the three-dimensional view alone, or with three slices of the CT beside
// it, of which one may be enlarged. While there are no slices it says why, and what would help.
#pragma once

#include <QImage>
#include <QWidget>
#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "ui/pending_strokes.h"
#include "ui/slices/ct_keeper.h"
#include "ui/slices/segment_keeper.h"
#include "ui/slices/slice_scene.h"
#include "ui/slices/tumour_keeper.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace hepatica {

class SliceBar;
class ThresholdDialog;
class SliceView;

class ViewLayout : public QWidget {
  public:
    struct Callbacks {
        // Where a person's CT lies; none: not after all.
        std::function<std::optional<std::filesystem::path>()> ask_for_ct;
        // To be marked in the three-dimensional view; none: nothing is.
        std::function<void(const std::optional<Vec3>&)> crosshair;
        std::function<void(const QString& doing, const Failure&)> failed;
        std::function<void()> ct_read = [] {};  // what was said of an earlier one no longer holds
        // A vessel was drawn through these places of the CT, which stays until it is answered.
        std::function<void(const Volume&, const std::vector<Vec3>&, VesselPen::Answered)> draw;
        std::function<void()> stop_drawing;
        // The vessels shall be made anew of these voxels.
        std::function<void(std::shared_ptr<const Volume> ct, Mask vessels)> remake;
        // A stroke at a tumour as a correction; false: not now. And so many of the last ones back.
        std::function<bool(const TreeEdit&)> paint_tumour;
        std::function<void(std::size_t)> take_strokes_back;
        // Likewise at vessels, which waits until they are made anew.
        std::function<void(const BrushStroke&)> paint_vessels;
        std::function<void(std::size_t)> take_vessel_strokes_back;
        // The surface of all tumours, for the three-dimensional view.
        std::function<void(const TriangleMesh&)> tumours;
        // A click on a place of the CT that is for a correction, and what that would be.
        std::function<void(const Vec3&)> correct;
        std::function<QString()> correction;
        // So many points of the three-dimensional view lie under bars.
        std::function<void(int top, int bottom)> view_covered = [](int, int) {};
    };
    // Takes over the view.
    ViewLayout(QWidget* view, Settings& settings, Callbacks callbacks, QWidget* parent = nullptr);
    ~ViewLayout() override;

    // See CtKeeper::show(). Returns how many diameters that were kept with him have no vessel.
    std::size_t show_patient(std::shared_ptr<const PatientCase> patient,
                             const std::filesystem::path& folder,
                             const std::filesystem::path& image);
    // A CT whose patient is not there yet: it can be looked at, and nothing can be done to it.
    // Nothing where a patient is shown.
    void show_image(std::shared_ptr<const Volume> ct);
    // The same patient with other corrections. Returns how many diameters lost their vessel by
    // them.
    std::size_t show_corrected(std::shared_ptr<const PatientCase> patient);
    // The corrections that are wanted of him, for the tumours among them.
    void show_tumours(const std::vector<TreeEdit>& edits) { tumours_.follow(edits); }
    // The strokes at his vessels that wait to be made into vessels.
    void show_strokes(const std::vector<PendingStroke>& strokes);
    // Asks for that, as the button does. Nothing where the slices are not there.
    void remake_painted() { scene_.brush().remake(); }
    // Forgets him; nothing is read any more.
    void clear();

    // The CT is read when slices are to be seen, and not before.
    void set_slices_visible(bool visible);
    // No tumour is being read or drawn.
    bool tumours_shown() const { return !tumours_.working(); }
    bool slices_visible() const { return slices_visible_; }
    // Opens the dialog of more or fewer vessels, for the slices that are or will be shown.
    void choose_threshold();
    ThresholdDialog& threshold() { return *threshold_; }
    // What holds the view and the slices, below their bar.
    QWidget& pictures() { return *pictures_; }
    // So many points of the pictures lie under bars, at their top and foot: what is written there
    // stands beside them.
    void keep_clear(int top, int bottom);
    // What is shown of view and slices, without what lies over them; `view`: the view's picture.
    QImage picture(const QImage& view) const;
    SliceScene& slices() { return scene_; }
    // For whoever wants the same CT, too.
    CtReadings& ct_readings() { return readings_; }
    SliceView& slice_view(SliceDirection direction) {
        return *views_[static_cast<std::size_t>(direction)];
    }

  private:
    void build(QWidget* view);
    void build_threshold();
    void connect_scene();
    void arrange();
    void clear_words();
    void want_segments();
    void mark_crosshair();
    void enlarge(SliceView* view);
    void say(const QString& text, bool can_choose);
    void ask();

    Callbacks callbacks_;
    SliceScene scene_;
    CtReadings readings_;
    CtKeeper keeper_;
    SegmentKeeper segments_;
    TumourKeeper tumours_;
    std::shared_ptr<const PatientCase> patient_;
    std::filesystem::path folder_;      // his case
    std::vector<BrushStroke> strokes_;  // that wait
    QWidget* view_;
    std::array<SliceView*, 3> views_{};
    SliceBar* bar_ = nullptr;
    ThresholdDialog* threshold_ = nullptr;
    QWidget* pictures_ = nullptr;
    QWidget* notice_ = nullptr;  // in the place of the slices
    QLabel* notice_text_ = nullptr;
    QPushButton* choose_ = nullptr;
    QGridLayout* grid_ = nullptr;
    SliceView* enlarged_ = nullptr;
    bool slices_visible_ = false;
    int covered_top_ = 0, covered_bottom_ = 0;
};

}  // namespace hepatica
