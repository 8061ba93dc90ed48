// SPDX-License-Identifier: GPL-3.0-or-later
// The user's cache of the built-in patient.
#pragma once

#include "core/opening/built_in_cache.h"

namespace hepatica {

// Needs the application's name; returns an empty cache where the user has no cache folder.
BuiltInCache users_cache();

}  // namespace hepatica
