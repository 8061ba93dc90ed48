// SPDX-License-Identifier: GPL-3.0-or-later
// A back end for tests of whatever plays on devices: the device's kernels, emulated. It names
// nothing of the device's code, so that tests of the window can have it.
#pragma once

#include <functional>
#include <string>

#include "core/scene/deform_back_end.h"

namespace hepatica::test {

struct EmulatedBackEnd {
    DeformBackEnd back_end;              // "cuda-emulated"
    std::function<long()> device_steps;  // that it has made
    std::function<void()> lose;          // from now on its device fails
};

EmulatedBackEnd emulated_back_end(const std::function<void(const std::string&)>& say =
                                      [](const std::string&) {});

}  // namespace hepatica::test
