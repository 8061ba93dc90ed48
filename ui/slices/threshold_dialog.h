// SPDX-License-Identifier: GPL-3.0-or-later
// Dialog that finds more or fewer vessels in the CT by a threshold and smoothing, with a preview in
// the slices. The slider stands at the threshold that the present vessels were made by, so that a
// threshold means the same before and after a rebuild.
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

// UI thread only. Measures the lines of the CT when it is shown and the scene has a CT; discards
// them when closed.
class ThresholdDialog : public QDialog {
  public:
    struct Ways {
        // Returns the function that reads the patient's organs; that one is called on the worker
        // thread.
        std::function<std::function<Mask()>()> organs;
        // The vessels are to be rebuilt from these voxels.
        std::function<void(std::shared_ptr<const Volume>, Mask)> remake;
        std::function<void(const Failure&)> failed;
    };
    // The scene must outlive the dialog.
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
    // Compares the vessels with those last seen; true if they were changed by hand.
    bool follow_vessels();
    void measure();
    void preview();
    void show_found(Mask vessels);
    // The slider stands for what there is.
    void stand_at(const ThresholdChoice& choice);
    void put(const ThresholdChoice& choice);
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
    std::shared_ptr<const Volume> ct_;  // the CT that lines_ are or will be measured in
    std::weak_ptr<const Volume> history_ct_;
    ThresholdHistory history_;  // of the vessels of history_ct_; kept while the dialog is closed
    std::uint64_t vessels_seen_ = 0;  // last SliceScene::systems_version()
    bool stale_ = false;              // a choice was made since the job began
    bool moved_ = false;              // a hand made the choice, of which nothing was rebuilt yet
    bool previewing_ = false;         // the scene shows a preview of this dialog
    std::unique_ptr<BackgroundJob> job_;
};

}  // namespace hepatica
