// SPDX-License-Identifier: GPL-3.0-or-later
// A device that fails: lost, out of memory, a driver too old. What was on it is lost; a body goes
// on from its last state on the host.
#pragma once

#include <stdexcept>

namespace hepatica::gpu {

class DeviceError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace hepatica::gpu
