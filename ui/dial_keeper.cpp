// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dial_keeper.h"

#include <utility>

#include "core/base/error.h"
#include "core/patient/case_archive.h"
#include "core/scene/measured_dial.h"
#include "core/study/dial_worker.h"

namespace hepatica {
namespace {

constexpr int quiet_ms = 1000;

}  // namespace

DialKeeper::DialKeeper(Found found) : found_(std::move(found)) {
    quiet_.setSingleShot(true);
    quiet_.setInterval(quiet_ms);
    QObject::connect(&quiet_, &QTimer::timeout, &quiet_, [this] {
        if (worker_) worker_->allow(!busy_);
    });
}

DialKeeper::~DialKeeper() = default;

void DialKeeper::show(std::shared_ptr<const PatientCase> patient, const DeformBackEnd& back_end) {
    worker_.reset();
    patient_ = std::move(patient);
    back_end_ = back_end;
    folder_.clear();
    points_.clear();
    busy_ = true;
    if (patient_->mesh.tetrahedra.empty()) return;
    try {
        points_ = measured_points(*patient_);
    } catch (const InputError&) {
        return;  // reported already when the case was opened
    }
    if (!next_dial_setting(points_, back_end_)) return;
    worker_ = std::make_unique<DialWorker>(
        patient_, points_,
        [this, body = patient_](const std::vector<QualityPoint>& points) {
            // Called on the worker's thread; results of a former patient are dropped.
            QMetaObject::invokeMethod(
                &quiet_,
                [this, body, points] {
                    if (body == patient_) take(points);
                },
                Qt::QueuedConnection);
        },
        back_end_);
}

void DialKeeper::take(std::vector<QualityPoint> points) {
    points_ = std::move(points);
    write();
    if (const std::optional<QualityDial> own = dial()) found_(*own);
    if (!next_dial_setting(points_, back_end_)) worker_.reset();
}

std::optional<QualityDial> DialKeeper::dial() const {
    // If a device has failed, there may be points of the processor alone.
    std::vector<QualityPoint> own = points_for(back_end_, points_);
    if (own.empty()) return std::nullopt;
    return dial_of_points(std::move(own));
}

void DialKeeper::keep_in(const std::filesystem::path& folder, const PatientCase* body) {
    if (body != patient_.get() || folder == folder_) return;
    folder_ = folder;
    write();
}

// A case that cannot be written, such as one on read-only media, gets no dial and is measured again
// next time. A case in a single file would have to be packed again; it gets its dial when it is
// saved.
void DialKeeper::write() const {
    if (folder_.empty() || points_.empty() || is_case_archive(folder_)) return;
    try {
        write_dial(folder_, dial_json(points_, *patient_));
    } catch (const InputError&) {
        return;
    }
}

void DialKeeper::set_busy(bool busy) {
    if (busy == busy_) return;
    busy_ = busy;
    if (busy) {
        quiet_.stop();
        if (worker_) worker_->allow(false);
    } else if (worker_) {
        quiet_.start();
    }
}

}  // namespace hepatica
