// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/album.h"

#include <utility>

#include "core/base/atomic_write.h"

namespace hepatica {

Album::Album(std::filesystem::path folder, PictureOptions options)
    : folder_(std::move(folder)), options_(std::move(options)) {}

AlbumPicture Album::add(const Frame& frame, const std::string& name, const std::string& caption) {
    return add(frame, options_, name, caption);
}

AlbumPicture Album::add(const Frame& frame, const PictureOptions& options, const std::string& name,
                        const std::string& caption) {
    pictures_.push_back({name + ".png", caption});
    write_png(folder_ / pictures_.back().file, draw_frame(frame, options).picture);
    return pictures_.back();
}

AlbumPicture Album::add(const Chart& chart, const std::string& name) {
    pictures_.push_back({name + ".png", chart.title});
    write_png(folder_ / pictures_.back().file, draw_chart(chart).picture);
    write_text_atomically(folder_ / (name + ".csv"), to_csv(chart));
    return pictures_.back();
}

}  // namespace hepatica
