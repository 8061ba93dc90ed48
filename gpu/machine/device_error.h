// SPDX-License-Identifier: GPL-3.0-or-later
// Failure of a device: lost, out of memory, or a driver too old. Its contents are lost; a body
// continues from its last state on the host.
#pragma once

#include <stdexcept>

namespace hepatica::gpu {

class DeviceError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace hepatica::gpu
