// SPDX-License-Identifier: GPL-3.0-or-later
// The dial that the window measures while nobody plays, and where it stays.
#include "ui/dial_keeper.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QTest>

#include "core/base/atomic_write.h"
#include "core/opening/built_in_cache.h"
#include "core/patient/case_header.h"
#include "core/scene/measured_dial.h"
#include "core/study/dial_study.h"
#include "tests/session/small_patient.h"
#include "tests/ui/patients/fake_ward.h"
#include "ui/patient_loader.h"

namespace hepatica {
namespace {

using test::small_patient;
constexpr int patience_ms = 120000;

class Dial : public ::testing::Test {
  protected:
    Dial() { testing::need_event_loop(); }

    bool wait_for_dials(int count) {
        return QTest::qWaitFor([&] { return dials_ >= count; }, patience_ms);
    }
    std::shared_ptr<const PatientCase> saved_patient() {
        auto patient = std::make_shared<PatientCase>(*small_patient());
        write_case(folder_, *patient);
        return patient;
    }

    QTemporaryDir temporary_;
    std::filesystem::path folder_ =
        std::filesystem::path(temporary_.path().toStdString()) / "a.hep";
    int dials_ = 0;
    DialKeeper keeper_{[this](const QualityDial&) { ++dials_; }};
};

TEST_F(Dial, IsMeasuredWhileNobodyPlaysAndKeptWithTheCase) {
    const auto patient = saved_patient();
    keeper_.show(patient);
    keeper_.keep_in(folder_, patient.get());
    EXPECT_TRUE(keeper_.has_work());
    EXPECT_FALSE(keeper_.dial().has_value());
    keeper_.set_busy(false);
    ASSERT_TRUE(wait_for_dials(1));
    EXPECT_TRUE(keeper_.dial().has_value()) << "for a play that begins now";
    PatientCase read = read_case_without_voxels(folder_);
    EXPECT_GE(measured_points(read).size(), 1u);
    ASSERT_TRUE(wait_for_dials(6));
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            read = read_case_without_voxels(folder_);
            return !next_dial_setting(measured_points(read)).has_value();
        },
        patience_ms));
    EXPECT_FALSE(keeper_.has_work());
    // Opened again, nothing is left to do.
    DialKeeper later([](const QualityDial&) { FAIL() << "measured twice"; });
    later.show(std::make_shared<const PatientCase>(read));
    later.set_busy(false);
    EXPECT_FALSE(later.has_work());
}

TEST_F(Dial, InTheCacheThatIsDamagedIsMeasuredAgain) {
    const BuiltInCache cache{folder_.parent_path() / "cache", "a program"};
    keep(cache, *small_patient());
    const OpenRequest request{.built_in = true, .reconstruct = {}, .cache = cache};
    const auto points_with = [&](const std::string& dial) {
        write_text_atomically(case_of(cache) / case_file::dial, dial);
        Job job;
        const LoadedPatient loaded = load_patient(request, job);
        EXPECT_EQ(loaded.cached_case, case_of(cache));
        return measured_points(*loaded.patient).size();
    };
    const std::string whole = dial_json({{{}, 1.0, 0.2, "this body"}}, *small_patient());
    EXPECT_EQ(points_with(whole), 1u);
    EXPECT_EQ(points_with(whole.substr(0, whole.size() / 2)), 0u);
}

TEST_F(Dial, OfAPatientWhoIsNotSavedComesIntoTheCaseLater) {
    keeper_.show(small_patient());
    keeper_.set_busy(false);
    ASSERT_TRUE(wait_for_dials(1));
    saved_patient();
    EXPECT_TRUE(measured_points(read_case_without_voxels(folder_)).empty());
    keeper_.keep_in(folder_, nullptr);  // of another patient
    EXPECT_TRUE(measured_points(read_case_without_voxels(folder_)).empty());
    keeper_.keep_in(folder_, small_patient().get());
    EXPECT_GE(measured_points(read_case_without_voxels(folder_)).size(), 1u);
}

// Saved once more without a change, it is written as it was opened.
TEST_F(Dial, StaysInACaseThatIsWrittenAnew) {
    const auto patient = saved_patient();
    keeper_.show(patient);
    keeper_.keep_in(folder_, patient.get());
    keeper_.set_busy(false);
    ASSERT_TRUE(wait_for_dials(1));
    saved_patient();
    ASSERT_TRUE(measured_points(read_case_without_voxels(folder_)).empty());
    keeper_.keep_in(folder_, patient.get());
    keeper_.case_was_written();
    EXPECT_GE(measured_points(read_case_without_voxels(folder_)).size(), 1u);
}

TEST_F(Dial, OfAPatientWhoLeftIsNoLongerMeasured) {
    keeper_.show(small_patient());
    keeper_.set_busy(false);
    ASSERT_TRUE(wait_for_dials(1));
    auto other = std::make_shared<PatientCase>(*small_patient());
    other->mesh.tetrahedra.clear();  // nothing of him moves
    keeper_.show(other);
    EXPECT_FALSE(keeper_.has_work());
    const int before = dials_;
    QCoreApplication::processEvents();  // what the worker before had still to say
    EXPECT_EQ(dials_, before);
}

}  // namespace
}  // namespace hepatica
