// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions of the small patient, and how tests play them.
#pragma once

#include <memory>

#include "core/session/session.h"
#include "tests/session/small_patient.h"

namespace hepatica::test {

inline std::unique_ptr<Session> new_session(const SceneSpec& spec = default_scene()) {
    Job job;
    return std::make_unique<Session>(small_patient(), spec, job);
}

// What the last of so many steps did.
inline SessionStep play(Session& session, int steps) {
    SessionStep last;
    for (int i = 0; i < steps; ++i) last = session.step();
    return last;
}

}  // namespace hepatica::test
