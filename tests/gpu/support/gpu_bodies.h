// SPDX-License-Identifier: GPL-3.0-or-later
// Machines and bodies for the tests of the GPU's back end.
#pragma once

#include <memory>
#include <ostream>
#include <string>

#include "core/deform/body/element_name.h"
#include "core/deform/stepper/step_back_end.h"
#include "gpu/machine/emulator.h"
#include "tests/deform/support/test_bodies.h"

namespace hepatica::test {

// "emulated", or "device" where there is one: null elsewhere.
std::unique_ptr<gpu::Machine> machine_of(const std::string& kind);
// Why the latter is null.
std::string no_device_because();

// A bar of bricks, clamped at one end, with damping and a weak tether.
BodyDescription gpu_bar();

// Bent, sheared and moving, with zero velocity where it is clamped.
BodyState lively(const Body& body);

// A pull sideways at the last vertices of the bar.
Grab pull_at_end(const BodyDescription& description);

// Solved to rounding, so that two ways of solving agree.
StepperOptions exact_options(const std::string& element);

// The largest distance between two fields, over the largest entry of the second.
double relative_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b);

// a - b
std::vector<Vec3> difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b);

}  // namespace hepatica::test
