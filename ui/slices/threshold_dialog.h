// SPDX-License-Identifier: GPL-3.0-or-later
// More or fewer vessels by a slider: what another threshold or a smoother surface would make of the
// CT shows in the slices at once, and becomes the vessels where the person says so. A threshold is
// the same afterwards as before: the slider stands at the one that the vessels were made by.
#pragma once

#include <QDialog>
#include <functional>
#include <memory>

#include "core/reconstruction/vessel_preview.h"
#include "ui/background_job.h"
#include "ui/slices/slice_scene.h"
#include "ui/slices/threshold_history.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QSlider;
class QSpinBox;

namespace hepatica {

// UI thread. Measures the lines of the CT when it is shown and the scene has one, and forgets them
// when it is closed.
class ThresholdDialog : public QDialog {
  public:
    struct Ways {
        // Of the patient; what it gives is called on the worker.
        std::function<std::function<Mask()>()> organs;
        // The vessels shall be made anew of these voxels.
        std::function<void(std::shared_ptr<const Volume>, Mask)> remake;
        std::function<void(const Failure&)> failed;
    };
    // The scene must outlive it.
    ThresholdDialog(SliceScene& scene, Ways ways, QWidget* parent = nullptr);
    ~ThresholdDialog() override;

    ThresholdChoice choice() const;
    bool measured() const { return lines_ != nullptr; }
    bool working() const { return job_ != nullptr; }

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void build();
    void follow_scene();
    // The vessels may be others than those that were seen last; true where another hand made them.
    bool follow_vessels();
    void measure();
    void preview();
    void show_found(Mask vessels);
    void stand_at(const ThresholdChoice& choice);
    void tell_volumes(const Mask& shown);
    bool changes_vessels() const { return !history_.empty() && choice() != history_.choice(); }
    void forget();
    void start(BackgroundJob::Work work, bool with_progress);

    SliceScene& scene_;
    Ways ways_;
    QSlider* share_ = nullptr;
    QLabel* share_text_ = nullptr;
    QSpinBox* refinement_ = nullptr;
    QLabel* state_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QPushButton* usual_ = nullptr;
    QPushButton* remake_ = nullptr;
    std::shared_ptr<const VesselPreview> lines_;
    std::shared_ptr<const Volume> ct_;  // that they are of, or shall be
    std::weak_ptr<const Volume> history_ct_;
    ThresholdHistory history_;        // of its vessels, also while this is closed
    std::uint64_t vessels_seen_ = 0;  // SliceScene::systems_version()
    bool stale_ = false;              // something was chosen since the job began
    bool previewing_ = false;         // the scene has a preview from here
    std::unique_ptr<BackgroundJob> job_;
};

}  // namespace hepatica
