// SPDX-License-Identifier: GPL-3.0-or-later
// Thumbnails of the series of a folder, decoded in the background one after another. One that
// cannot be decoded is reported as a null image, not as an error.
#pragma once

#include <QImage>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "ui/background_job.h"

namespace hepatica {

// UI thread only; needs Qt's event loop and no other part of Qt.
class SeriesThumbnails {
  public:
    // Receives the image of the series with this index; null if it cannot be decoded.
    using Show = std::function<void(std::size_t series, const QImage&)>;

    // `slices`: a DICOM file of each series, may be empty; `side`: pixels of the longer side.
    // Starts at once and calls `show` from the event loop, once for each series.
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
