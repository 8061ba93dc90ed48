// SPDX-License-Identifier: GPL-3.0-or-later
// Runs every kernel on the host in one thread: it computes what a device would. Results are bitwise
// equal, because neither uses fused multiply-add.
#pragma once

#include <memory>

#include "gpu/machine/machine.h"

namespace hepatica::gpu {

// The order in which blocks, and threads within a phase, are run. Results must not depend on it.
enum class BlockOrder { ascending, descending, shuffled };

std::unique_ptr<Machine> make_emulator(BlockOrder order = BlockOrder::ascending);

}  // namespace hepatica::gpu
