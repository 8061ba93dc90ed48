// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/series_thumbnails.h"

#include <cstring>
#include <utility>

#include "core/image/thumbnail.h"

namespace hepatica {
namespace {

QImage as_image(const Thumbnail& picture) {
    QImage image(picture.width, picture.height, QImage::Format_Grayscale8);
    const auto width = static_cast<std::size_t>(picture.width);
    for (int row = 0; row < picture.height; ++row)
        std::memcpy(image.scanLine(row),
                    picture.grey.data() + static_cast<std::size_t>(row) * width, width);
    return image;
}

}  // namespace

SeriesThumbnails::SeriesThumbnails(std::vector<std::filesystem::path> slices, int side, Show show)
    : slices_(std::move(slices)), side_(side), show_(std::move(show)) {
    begin(0);
}

void SeriesThumbnails::begin(std::size_t series) {
    if (series >= slices_.size()) return job_.reset();
    BackgroundJob::Callbacks callbacks;
    // Reading the series will report the reason.
    callbacks.failed = [this, series](const Failure&) { show_(series, {}); };
    callbacks.ended = [this, series] { begin(series + 1); };
    job_ = std::make_unique<BackgroundJob>(
        [this, series, file = slices_[series], side = side_](Job& job) -> std::function<void()> {
            job.throw_if_cancelled();
            const QImage image = as_image(thumbnail_of(file, side, job));
            return [this, series, image] { show_(series, image); };
        },
        std::move(callbacks));
}

}  // namespace hepatica
