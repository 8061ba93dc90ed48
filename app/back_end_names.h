// SPDX-License-Identifier: GPL-3.0-or-later
// The back ends by the names that the command line takes, without anything of a device: what is
// compiled together with Qt cannot read the device's code.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/scene/deform_back_end.h"

namespace hepatica {

const std::vector<std::string>& back_end_names();

// Is told what a person should know, on whatever thread makes steps.
using SayOfBackEnd = std::function<void(const std::string&)>;
void warn_of_back_end(const std::string& what);  // in the log

// choose_back_end() of back_end_choice.h, as far as a play needs it.
DeformBackEnd back_end_named(const std::string& name, const SayOfBackEnd& say = warn_of_back_end);

}  // namespace hepatica
