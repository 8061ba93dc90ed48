// SPDX-License-Identifier: GPL-3.0-or-later
// Small pictures of the series of a folder, decoded beside the window one after another, the first
// series first. One that cannot be decoded is told as none, and never as an error.
#pragma once

#include <QImage>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "ui/background_job.h"

namespace hepatica {

// UI thread; needs Qt's event loop and nothing else of the toolkit.
class SeriesThumbnails {
  public:
    // Of the series with this index; null where there is nothing to be seen.
    using Show = std::function<void(std::size_t series, const QImage&)>;

    // `slices`: a DICOM file of each series, may be empty; `side`: pixels of the longer side.
    // Begins at once; `show` is called from the event loop, once for each series.
    SeriesThumbnails(std::vector<std::filesystem::path> slices, int side, Show show);

    bool working() const { return job_ != nullptr; }

  private:
    void begin(std::size_t series);

    std::vector<std::filesystem::path> slices_;
    int side_;
    Show show_;
    std::unique_ptr<BackgroundJob> job_;  // ends with this object
};

}  // namespace hepatica
