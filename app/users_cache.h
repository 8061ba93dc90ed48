// SPDX-License-Identifier: GPL-3.0-or-later
// Where this program keeps the built-in patient for this user.
#pragma once

#include "core/opening/built_in_cache.h"

namespace hepatica {

// Needs the application's name; an empty cache where the user has no folder for it.
BuiltInCache users_cache();

}  // namespace hepatica
