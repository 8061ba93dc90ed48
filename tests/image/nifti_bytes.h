// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>
#include <filesystem>
#include <string>

#include "core/image/volume_reader.h"
#include "core/image/volume_writer.h"
#include "tests/image/image_fixtures.h"

namespace hepatica::testing_support {

// A NIfTI-1 file with some bytes of its header replaced.
class NiftiFile {
  public:
    explicit NiftiFile(const TemporaryFolder& folder) : path_(folder / "case.nii") {
        write_nifti(path_, patterned_volume(small_grid()));
        bytes_ = bytes_of_file(path_);
    }
    template <class T>
    NiftiFile& set(std::size_t offset, T value) {
        std::memcpy(bytes_.data() + offset, &value, sizeof(T));
        return *this;
    }
    NiftiFile& cut(std::size_t size) {
        bytes_.resize(size);
        return *this;
    }
    void write() const { write_bytes(path_, bytes_); }
    std::string refusal_of_volume() {
        write();
        return refusal([&] {
            Job job;
            read_volume(path_, job);
        });
    }
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
    std::string bytes_;
};

}  // namespace hepatica::testing_support
