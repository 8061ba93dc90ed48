// SPDX-License-Identifier: GPL-3.0-or-later
// What a file holds once everything that is packed in it is unpacked: gzip and zlib streams (NIfTI,
// PNG, VTK) and base64 (VTK), to any depth that these programs make.
#pragma once

#include <string>

namespace hepatica::test {

// The bytes, followed by whatever is packed in them.
std::string unpacked(const std::string& bytes, int depth = 3);

}  // namespace hepatica::test
