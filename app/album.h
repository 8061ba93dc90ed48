// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of a headless session: drawn into one folder, and listed with their captions.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "render/chart.h"
#include "render/offscreen_picture.h"

namespace hepatica {

// The moments at which an injection is shown, in percent of the time after which most vessels are
// reached; large vessels fill within the first few percent.
inline constexpr std::array<int, 4> drug_moments_percent{2, 10, 30, 100};

struct AlbumPicture {
    std::filesystem::path file;  // relative to the folder
    std::string caption;
};

class Album {
  public:
    // Options of every picture of a frame that is added without its own. The folder must exist.
    Album(std::filesystem::path folder, PictureOptions options);

    // Write NAME.png, and NAME.csv for a chart. Throw InputError where that fails.
    AlbumPicture add(const Frame& frame, const std::string& name, const std::string& caption);
    AlbumPicture add(const Frame& frame, const PictureOptions& options, const std::string& name,
                     const std::string& caption);
    AlbumPicture add(const Chart& chart, const std::string& name);

    const PictureOptions& options() const { return options_; }
    const std::vector<AlbumPicture>& pictures() const { return pictures_; }

  private:
    std::filesystem::path folder_;
    PictureOptions options_;
    std::vector<AlbumPicture> pictures_;
};

}  // namespace hepatica
