// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a case's files from a folder, whether the case is one or an archive that is unpacked first.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/error.h"
#include "core/base/temporary_folder.h"
#include "core/patient/case_archive.h"

namespace hepatica {

// Returns use(folder). An error below the temporary `folder` names `place` instead.
template <typename Use>
auto in_place_of(const std::filesystem::path& folder, const std::filesystem::path& place,
                 const Use& use) {
    try {
        return use(folder);
    } catch (const InputError& error) {
        std::string where = error.place();
        const std::string temporary = folder.string();
        if (where.starts_with(temporary)) where.replace(0, temporary.size(), place.string());
        throw InputError(error.problem(), where, error.remedy());
    }
}

// Returns use(folder) with the case's folder: `place` itself, or the one that an archive is
// unpacked to. Errors then name the archive.
template <typename Use>
auto in_folder(const std::filesystem::path& place, const Use& use) {
    if (!is_case_archive(place)) return use(place);
    const TemporaryFolder unpacked;
    unpack_case(place, unpacked.path());
    return in_place_of(unpacked.path(), place, use);
}

}  // namespace hepatica
