// SPDX-License-Identifier: GPL-3.0-or-later
// Runs every kernel on the host, on one thread: what a device would compute, without one. Neither
// rounds otherwise than the other, since neither fuses products.
#pragma once

#include <memory>

#include "gpu/machine/machine.h"

namespace hepatica::gpu {

// In which order blocks, and threads within a phase, are run. No result depends on it.
enum class BlockOrder { ascending, descending, shuffled };

std::unique_ptr<Machine> make_emulator(BlockOrder order = BlockOrder::ascending);

}  // namespace hepatica::gpu
