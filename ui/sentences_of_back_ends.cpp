// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences about the back ends that compute a play: processor, device, and why not the device.
#include <array>

#include "ui/core_sentences.h"
#include "ui/words.h"

namespace hepatica {
namespace {

constexpr std::array sentences_back_ends{
    Words::id("The chosen back end is not to be had, so that the processor makes the steps: %1. "
              "%2"),
    Words::id("The processor makes the steps: %1"),
    Words::id("The processor makes single steps: %1"),
    Words::id("The device's steps leave out tension, by which taut vessels resist being turned: "
              "they err more where a vessel is pulled"),
    Words::id("Settings of the dial that were measured on %1 (%2) are left out: it does not make "
              "the steps here"),
    Words::id("emulated on the processor"),
    // Why no device is available.
    Words::id("this build has no CUDA"),
    Words::id("this computer has no NVIDIA driver"),
    Words::id("the driver knows CUDA %1, which is older than the %2 of this build"),
    Words::id("this computer has no CUDA device that can be used"),
    Words::id("the CUDA device does not answer"),
    Words::id("the CUDA back end"),
    Words::id("Use the processor, or build with HEPATICA_CUDA=ON where nvcc is"),
    Words::id("Use the processor, or a computer with an NVIDIA device"),
    // Why a device leaves some or all steps to the processor.
    Words::id("the device failed (%1)"),
    Words::id("no memory on the device: %1"),
    Words::id("the device does not answer: %1"),
    Words::id("the device failed: %1"),
    Words::id("a kernel could not be launched: %1"),
    Words::id("a copy to the device failed: %1"),
    Words::id("a copy from the device failed: %1"),
    Words::id("its elements have no kernels yet"),
    Words::id("Newton's method has no kernels yet"),
    Words::id("the solver cholesky has no kernels"),
    Words::id("the published step, E of eq. (11) and audits have no kernels"),
    Words::id("a piece would pay for energy or momentum of others"),
    Words::id("what its surfaces exchanged would be lost"),
    Words::id("a free body is about to meet itself"),
    Words::id("a step has to be shortened, lest something pass through"),
    // On settings, and on one that could not be measured.
    Words::id("%1, on the processor"),
    Words::id("has left steps to the processor"),
    Words::id("Measure again, or with --backend cpu"),
    // On a recording in a window without devices.
    Words::id("is not to be had here"),
    Words::id("Let the processor make the steps"),
};

}  // namespace

std::span<const char* const> sentences_of_back_ends() {
    return sentences_back_ends;
}

}  // namespace hepatica
