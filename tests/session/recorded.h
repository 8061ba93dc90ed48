// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps a session's recording in memory, for tests.
#pragma once

#include <memory>
#include <utility>

#include "core/session/session.h"

namespace hepatica::test {

// Filled from now on, with every step of the session.
inline std::shared_ptr<Recording> keep_recording(Session& session) {
    auto recording = std::make_shared<Recording>(session.recording_start());
    session.record([recording](RecordedStep step) { recording->steps.push_back(std::move(step)); });
    return recording;
}

}  // namespace hepatica::test
