// SPDX-License-Identifier: GPL-3.0-or-later
// Which program this is, to the build: what it keeps for itself is not taken for that of another.
#pragma once

#include <string>

namespace hepatica {

// The version, and the build ID that the linker made of all its code (or, where there is none, size
// and time of the program's file).
std::string program_identity();

}  // namespace hepatica
