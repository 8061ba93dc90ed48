// SPDX-License-Identifier: GPL-3.0-or-later
// Identifies this build of the program, so that caches of different builds are kept apart.
#pragma once

#include <string>

namespace hepatica {

// The version, and the build ID that the linker computed from the code, or, without one, size and
// time of the program's file.
std::string program_identity();

}  // namespace hepatica
