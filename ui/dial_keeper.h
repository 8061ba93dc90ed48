// SPDX-License-Identifier: GPL-3.0-or-later
// The dial of the patient who is shown: measured on his own body while nobody plays, once for a
// body, and kept in his case where that lies on disk with this body.
#pragma once

#include <QTimer>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "core/deform/stepper/quality_dial.h"
#include "core/patient/patient_case.h"
#include "core/scene/deform_back_end.h"

namespace hepatica {

class DialWorker;

// UI thread; needs Qt's event loop and nothing else of the toolkit.
class DialKeeper {
  public:
    using Found = std::function<void(const QualityDial&)>;

    // `found`: UI thread, whenever another setting was measured: the dial so far.
    explicit DialKeeper(Found found);
    // Ends after the step under way.
    ~DialKeeper();

    // Forgets the patient before. Nothing is measured where his case holds a whole dial of this
    // body, or one that is damaged. What is measured, and found, is what this back end plays.
    void show(std::shared_ptr<const PatientCase> patient,
              const DeformBackEnd& back_end = cpu_back_end());
    // The case that holds this body; empty: none does. Where it is the body that is measured, what
    // was measured is kept there.
    void keep_in(const std::filesystem::path& folder, const PatientCase* body);
    // Whether somebody plays or another job runs: then nothing is measured, and not for a second
    // after.
    void set_busy(bool busy);
    // Whether settings of the patient who is shown are still to be measured.
    bool has_work() const { return worker_ != nullptr; }

  private:
    void take(std::vector<QualityPoint> points);
    void write() const;

    Found found_;
    std::shared_ptr<const PatientCase> patient_;
    DeformBackEnd back_end_ = cpu_back_end();  // to be compared with: the worker has its own
    std::filesystem::path folder_;
    std::vector<QualityPoint> points_;  // measured since the patient is shown, and before
    bool busy_ = true;
    QTimer quiet_;  // runs out when nobody has played for a second
    std::unique_ptr<DialWorker> worker_;
};

}  // namespace hepatica
