// SPDX-License-Identifier: GPL-3.0-or-later
// The middle of the window: the 3D view alone, or beside three slices of the CT, of which one can
// be enlarged. Without slices it tells why, and what would help.
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

namespace hepatica {

class SliceBar;
class SliceNotice;
class ThresholdDialog;
class SliceView;

class ViewLayout : public QWidget {
  public:
    struct Callbacks {
        // Asks for the place of the patient's CT; nullopt: cancelled.
        std::function<std::optional<std::filesystem::path>()> ask_for_ct;
        // Marks this point in the 3D view; nullopt: removes the mark.
        std::function<void(const std::optional<Vec3>&)> crosshair;
        std::function<void(const QString& doing, const Failure&)> failed;
        // A CT was read, or another one chosen: messages about an earlier one no longer hold.
        std::function<void()> other_ct = [] {};
        // Draws a vessel through these places of the CT, which stays valid until the answer.
        std::function<void(const Volume&, const std::vector<Vec3>&, VesselPen::Answered)> draw;
        std::function<void()> stop_drawing;
        // Rebuilds the vessels from these voxels.
        std::function<void(std::shared_ptr<const Volume> ct, Mask vessels)> remake;
        // Adds a stroke at a tumour as a correction (false: impossible now), and takes the last n
        // back.
        std::function<bool(const TreeEdit&)> paint_tumour;
        std::function<void(std::size_t)> take_strokes_back;
        // Likewise for vessels; these strokes wait until the vessels are rebuilt.
        std::function<void(const BrushStroke&)> paint_vessels;
        std::function<void(std::size_t)> take_vessel_strokes_back;
        // The surface of all tumours, for the 3D view.
        std::function<void(const TriangleMesh&)> tumours;
        // A click at this place is for a correction; and that correction in words.
        std::function<void(const Vec3&)> correct;
        std::function<QString()> correction;
        // Reconstructs the CT anew with the seeds that were set.
        std::function<void()> reconstruct = [] {};
        // Bars cover this many points of the 3D view.
        std::function<void(int top, int bottom)> view_covered = [](int, int) {};
    };
    // Takes ownership of the view.
    ViewLayout(QWidget* view, Settings& settings, Callbacks callbacks, QWidget* parent = nullptr);
    ~ViewLayout() override;

    // See CtKeeper::show(). Without measurements: slices().measurements() shows them.
    void show_patient(std::shared_ptr<const PatientCase> patient,
                      const std::filesystem::path& folder, const std::filesystem::path& image);
    // Shows the CT of a patient who is still being reconstructed; it can only be looked at. No
    // effect if a patient is shown.
    void show_image(std::shared_ptr<const Volume> ct);
    // The same patient with other corrections. Returns how many diameters lost their vessel by
    // them.
    std::size_t show_corrected(std::shared_ptr<const PatientCase> patient);
    // The patient's present corrections; the tumours among them are shown.
    void show_tumours(const std::vector<TreeEdit>& edits) { tumours_.follow(edits); }
    // Strokes at the vessels that wait for a rebuild.
    void show_strokes(const std::vector<PendingStroke>& strokes);
    // Asks for a rebuild, as the button does. No effect without strokes.
    void remake_painted() { scene_.brush().remake(); }
    // Removes the patient and stops reading.
    void clear();

    // The CT is read only once slices are to be shown.
    void set_slices_visible(bool visible);
    // No tumour is being read or drawn.
    bool tumours_shown() const { return !tumours_.working(); }
    bool slices_visible() const { return slices_visible_; }
    // Opens the dialog of more or fewer vessels.
    void choose_threshold();
    ThresholdDialog& threshold() { return *threshold_; }
    // The widget that holds view and slices, below their bar.
    QWidget& pictures() { return *pictures_; }
    // Bars cover this many points at the top and foot of the pictures; text is kept clear of them.
    void keep_clear(int top, int bottom);
    // What is shown of view and slices, without what lies over them; `view`: the view's picture.
    QImage picture(const QImage& view) const;
    SliceScene& slices() { return scene_; }
    // For others that want the same CT.
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
    void ask();
    void cancel_reading();

    Callbacks callbacks_;
    SliceScene scene_;
    CtReadings readings_;
    CtKeeper keeper_;
    SegmentKeeper segments_;
    TumourKeeper tumours_;
    std::shared_ptr<const PatientCase> patient_;
    std::filesystem::path folder_;      // of the case
    std::vector<BrushStroke> strokes_;  // waiting for a rebuild
    QWidget* view_;
    std::array<SliceView*, 3> views_{};
    SliceBar* bar_ = nullptr;
    ThresholdDialog* threshold_ = nullptr;
    QWidget* pictures_ = nullptr;
    SliceNotice* notice_ = nullptr;  // shown instead of the slices
    QGridLayout* grid_ = nullptr;
    SliceView* enlarged_ = nullptr;
    bool slices_visible_ = false;
    int covered_top_ = 0, covered_bottom_ = 0;
};

}  // namespace hepatica
