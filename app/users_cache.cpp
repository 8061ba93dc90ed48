// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/users_cache.h"

#include <QStandardPaths>

#include "app/program_identity.h"
#include "ui/paths.h"

namespace hepatica {

BuiltInCache users_cache() {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::CacheLocation);
    if (folder.isEmpty()) return {};
    return {to_path(folder), program_identity()};
}

}  // namespace hepatica
