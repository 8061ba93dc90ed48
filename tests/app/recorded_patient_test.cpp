// SPDX-License-Identifier: GPL-3.0-or-later
// The patient of a recording, where no case lies beside it.
#include "app/recorded_patient.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/temporary_folder.h"
#include "core/opening/open_patient.h"
#include "tests/session/small_patient.h"

namespace hepatica {
namespace {

// A report names him as the window does, also where nobody said who was played.
TEST(RecordedPatient, TheBuiltInOneHasHisName) {
    const TemporaryFolder folder;
    const BuiltInCache cache{folder.path() / "cache", "this program"};
    keep(cache, *test::small_patient());
    Recording recording;
    recording.patient_hash = hash_of(*test::small_patient());
    Job job;
    const PatientCase patient =
        recorded_patient(recording, folder.path() / "play.hrec", {}, &cache, 1, job);
    EXPECT_EQ(hash_of(patient), recording.patient_hash);
    EXPECT_EQ(patient.source.name, built_in_title);
}

}  // namespace
}  // namespace hepatica
