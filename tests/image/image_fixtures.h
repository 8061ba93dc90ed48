// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of the image room share: a folder that cleans up after itself, images with a
// different value in every voxel, and the real data where they are.
#pragma once

#include <unistd.h>

#include <Eigen/Geometry>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/image/volume.h"

namespace hepatica::testing_support {

// With letters that are not ASCII in its name, as users have them.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        static int count = 0;
        path_ = std::filesystem::temp_directory_path() /
                ("hepatica Größe 肝 " + std::to_string(getpid()) + "-" + std::to_string(count++));
        std::filesystem::create_directories(path_);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  private:
    std::filesystem::path path_;
};

inline Grid small_grid() {
    Grid grid;
    grid.dims = {13, 11, 9};
    grid.spacing_mm = {0.75, 0.8, 1.5};
    grid.origin_mm = {-31.25, 17.5, -402.0};
    return grid;
}

inline Grid turned_grid() {
    Grid grid = small_grid();
    grid.direction = Eigen::AngleAxisd(0.3, Vec3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
    return grid;
}

// Asymmetric along every axis, so that a flip or a swap shows.
inline Volume patterned_volume(const Grid& grid) {
    Volume volume(grid);
    for (std::size_t i = 0; i < volume.voxels.size(); ++i) {
        const Index3 at = grid.index_of(i);
        volume.voxels[i] =
            static_cast<std::int16_t>(at[0] + 20 * at[1] + 400 * at[2] - 1024 + at[0] * at[1]);
    }
    return volume;
}

inline std::string bytes_of_file(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

inline void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary)
        .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

// The folder of public patients, which is not part of the project.
inline std::optional<std::filesystem::path> real_data(const std::string& name) {
    const char* chosen = std::getenv("HEPATICA_TEST_DATA");
    const std::filesystem::path root =
        chosen != nullptr ? std::filesystem::path(chosen)
                          : std::filesystem::path(HEPATICA_SOURCE_DIR) / "../shared/data";
    if (!std::filesystem::exists(root / name)) return std::nullopt;
    return root / name;
}

// The message of the InputError that the call throws; "" where it throws none.
template <class Call>
std::string refusal(const Call& call) {
    try {
        call();
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace hepatica::testing_support
