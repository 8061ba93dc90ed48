// SPDX-License-Identifier: GPL-3.0-or-later
// A test of the slices of a CT of a few voxels, in a window with a fake simulation.
#pragma once

#include <filesystem>
#include <memory>

#include <QTest>
#include <QWheelEvent>

#include "core/image/volume_writer.h"
#include "core/patient/image_digest.h"
#include "tests/ui/fake_window_test.h"
#include "ui/paths.h"
#include "ui/slices/slice_view.h"
#include "ui/slices/view_layout.h"

namespace hepatica::testing {

// Each voxel's value tells its index.
inline Volume numbered_ct() {
    Grid grid;
    grid.dims = {40, 50, 60};
    grid.spacing_mm = Vec3(3, 3, 3);
    grid.origin_mm = Vec3(-60, -75, -90);
    Volume ct(grid);
    for (std::size_t i = 0; i < ct.voxels.size(); ++i)
        ct.voxels[i] = static_cast<std::int16_t>(i % 900);
    return ct;
}

class SlicesTest : public FakeWindowTest {
  protected:
    SlicesTest() : file_(to_path(folder_.filePath("ct.nii.gz"))) {
        write_nifti(file_, ct_);
        open_built_in();
        auto patient = std::make_shared<PatientCase>();
        patient->source.image_sha256 = digest_of(ct_);
        patient->source.image_grid = ct_.grid;
        VesselSegment vessel;
        vessel.system = VascularSystem::portal;
        vessel.points_mm = {Vec3(0, 0, -30), Vec3(0, 0, 30)};
        vessel.radii_mm = {4.0, 5.0};
        patient->tree.segments = {vessel};
        patient->mask = Mask(ct_.grid);
        patient->mask.voxels[ct_.grid.offset(20, 25, 30)] = 1;
        patient_ = patient;
    }
    ViewLayout& views() { return window_.view_layout(); }
    SliceScene& scene() { return views().slices(); }
    SliceView& view(SliceDirection direction) { return views().slice_view(direction); }
    // With the CT where the patient was reconstructed from just now.
    void show_slices() {
        views().show_patient(patient_, {}, file_);
        QTest::keyClick(&window_, Qt::Key_F7);
        ASSERT_TRUE(wait_for([this] { return !scene().empty(); }));
    }
    void turn_wheel(SliceView& slice, int notches, Qt::KeyboardModifiers keys = {}) {
        const QPointF place(slice.rect().center());
        QWheelEvent wheel(place, slice.mapToGlobal(place), {}, QPoint(0, 120 * notches),
                          Qt::NoButton, keys, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&slice, &wheel);
    }

    const Volume ct_ = numbered_ct();
    const std::filesystem::path file_;
    std::shared_ptr<const PatientCase> patient_;
};

}  // namespace hepatica::testing
