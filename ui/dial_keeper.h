// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the quality dial of the shown patient: measures it on his body while nobody plays, once per
// body, and stores it in his case if that holds this body.
#pragma once

#include <QTimer>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/deform/stepper/quality_dial.h"
#include "core/patient/patient_case.h"
#include "core/scene/deform_back_end.h"

namespace hepatica {

class DialWorker;

// UI thread only; needs Qt's event loop and no other part of Qt.
class DialKeeper {
  public:
    using Found = std::function<void(const QualityDial&)>;

    // `found` is called on the UI thread with the dial so far, whenever another setting was
    // measured.
    explicit DialKeeper(Found found);
    // Waits for the step under way.
    ~DialKeeper();

    // Starts with another patient. Nothing is measured if his case holds a complete dial of this
    // body or a damaged one. Points are measured, and dials found, for `back_end`.
    void show(std::shared_ptr<const PatientCase> patient,
              const DeformBackEnd& back_end = cpu_back_end());
    // The case that holds `body`; empty: none. If `body` is being measured, the points are stored
    // there.
    void keep_in(const std::filesystem::path& folder, const PatientCase* body);
    // The case that holds the body was written anew, as it was opened: without what was measured
    // since.
    void case_was_written() { write(); }
    // While busy (somebody plays or another job runs), and for a second afterwards, nothing is
    // measured.
    void set_busy(bool busy);
    // The dial of the shown patient so far, for a play that begins now; nullopt: nothing was
    // measured.
    std::optional<QualityDial> dial() const;
    // Whether settings of the shown patient remain to be measured.
    bool has_work() const { return worker_ != nullptr; }

  private:
    void take(std::vector<QualityPoint> points);
    void write() const;

    Found found_;
    std::shared_ptr<const PatientCase> patient_;
    DeformBackEnd back_end_ = cpu_back_end();  // to compare with; the worker has a copy
    std::filesystem::path folder_;
    std::vector<QualityPoint> points_;  // measured now or read from the case
    bool busy_ = true;
    QTimer quiet_;  // fires after a second without play
    std::unique_ptr<DialWorker> worker_;
};

}  // namespace hepatica
