// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps a session's recording in memory, and plays it again, for tests.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>

#include "core/base/job.h"
#include "core/session/recording_file.h"
#include "core/session/replay.h"
#include "core/session/session.h"
#include "tests/session/small_patient.h"

namespace hepatica::test {

// Filled from now on, with every step of the session.
inline std::shared_ptr<Recording> keep_recording(Session& session) {
    auto recording = std::make_shared<Recording>(session.recording_start());
    session.record([recording](RecordedStep step) { recording->steps.push_back(std::move(step)); });
    return recording;
}

// Writes the recording of a session on the small patient and reads it again; played from its start
// and from the last keyframe before each of these steps, it must end with the session's bits.
inline void expect_to_play_again(const Session& session, const Recording& recording,
                                 std::initializer_list<std::uint64_t> from_steps) {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    const auto file = std::filesystem::path(::testing::TempDir()) /
                      (std::string(test->test_suite_name()) + "." + test->name() + ".hrec");
    write_recording(file, recording);
    const Recording read = read_recording(file);
    Job job;
    const auto expect_from = [&](std::uint64_t from) {
        const ReplayResult again = replay(read, small_patient(), job, from);
        EXPECT_FALSE(again.diverged_at) << *again.diverged_at;
        EXPECT_EQ(again.state_hash, session.state_hash()) << "from " << from;
        EXPECT_EQ(again.began_at > 0, from > 0);
    };
    expect_from(0);
    for (const std::uint64_t from : from_steps) expect_from(from);
}

}  // namespace hepatica::test
