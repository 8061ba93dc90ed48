// SPDX-License-Identifier: GPL-3.0-or-later
// The token of a stop that has been asked for already.
#pragma once

#include <stop_token>

namespace hepatica::test {

inline std::stop_token asked_to_stop() {
    std::stop_source source;
    source.request_stop();
    return source.get_token();
}

}  // namespace hepatica::test
