// SPDX-License-Identifier: GPL-3.0-or-later
// Names of the back ends on the command line, without including device code, because Qt's macros do
// not compile together with it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/scene/deform_back_end.h"

namespace hepatica {

const std::vector<std::string>& back_end_names();

// Receives messages for the user, on the thread that makes the steps.
using SayOfBackEnd = std::function<void(const std::string&)>;
void warn_of_back_end(const std::string& what);  // writes to the log

// The back end of choose_back_end() in back_end_choice.h.
DeformBackEnd back_end_named(const std::string& name, const SayOfBackEnd& say = warn_of_back_end);

}  // namespace hepatica
