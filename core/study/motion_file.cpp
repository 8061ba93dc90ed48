// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/motion_file.h"

#include <algorithm>
#include <fstream>
#include <string_view>

#include "core/base/atomic_write.h"

namespace hepatica {

static_assert(sizeof(Vec3) == 3 * sizeof(double));

void write_motion(const std::filesystem::path& file, const CentrelineMotion& motion) {
    write_text_atomically(
        file, {reinterpret_cast<const char*>(motion.data()), motion.size() * sizeof(Vec3)});
}

std::optional<CentrelineMotion> read_motion(const std::filesystem::path& file,
                                            std::size_t vectors) {
    std::error_code error;
    if (std::filesystem::file_size(file, error) != vectors * sizeof(Vec3) || error)
        return std::nullopt;
    CentrelineMotion motion(vectors);
    std::ifstream in(file, std::ios::binary);
    in.read(reinterpret_cast<char*>(motion.data()),
            static_cast<std::streamsize>(vectors * sizeof(Vec3)));
    if (!in || !std::ranges::all_of(motion, [](const Vec3& v) { return v.allFinite(); }))
        return std::nullopt;
    return motion;
}

}  // namespace hepatica
