// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/patient_space.h"
#include "core/image/byte_stream.h"
#include "core/image/dicom_header.h"
#include "core/image/dicom_rle.h"
#include "core/image/volume_reader.h"
#include "tests/fuzz/input_file.h"
#include "tests/fuzz/readers.h"
#include "tests/fuzz/refuse_or.h"

namespace hepatica::fuzz {

namespace {

void read_dicom_header_bytes(Bytes bytes) {
    std::istringstream in(std::string(bytes.begin(), bytes.end()));
    const auto header = parse_dicom_header(in, bytes.size());
    if (!header) return;
    if (!header->compressed && header->has_pixels && header->deflated_at == 0)
        promise(header->pixel_offset <= bytes.size(), "pixels begin within the file");
    for (const FileRange& range : header->fragments)
        promise(range.offset + range.bytes <= bytes.size(), "fragments lie within the file");
}

// Two slices of a folder, the second the first one's copy a millimetre and a half on: the whole way
// through the choice of a series, its geometry and its pixels.
void read_dicom_slices(Bytes bytes) {
    const auto first = file_of(bytes, "ct/a.dcm");
    std::vector<std::uint8_t> moved(bytes.begin(), bytes.end());
    const std::string_view text(reinterpret_cast<const char*>(moved.data()), moved.size());
    const std::string_view position = "\\-402 ";
    if (const std::size_t at = text.find(position); at != std::string_view::npos)
        moved[at + 4] = '3';
    file_of(moved, "ct/b.dcm");
    refuse_or([&] {
        Job job;
        read_volume(first.parent_path(), job);
    });
}

// The first two bytes choose the picture's size and the width of its words.
void read_rle(Bytes bytes) {
    if (bytes.size() < 2) return;
    const std::size_t pixels = bytes[0] + 1u, word_bytes = 1u << (bytes[1] % 3);
    const auto words = decode_rle(bytes.subspan(2), pixels, word_bytes);
    if (words) promise(words->size() == pixels * word_bytes, "as many pixels as asked for");
}

void read_image(Bytes bytes, const char* name) {
    const auto file = file_of(bytes, name);
    refuse_or([&] {
        Job job;
        const Volume volume = read_volume(file, job);
        promise(volume.voxels.size() == volume.grid.count(), "a value per voxel");
        // The file's first voxel lies within; the grid's may be another corner, three extents on.
        promise(volume.grid.origin_mm.cwiseAbs().maxCoeff() <= 4.0 * farthest_mm,
                "a place in the room");
    });
    refuse_or([&] {
        Job job;
        read_mask(file, job);
    });
    refuse_or([&] {
        Job job;
        read_label_map(file, job);
    });
}

void read_nifti(Bytes bytes) {
    read_image(bytes, "image.nii");
}
void read_meta(Bytes bytes) {
    read_image(bytes, "image.mha");
}
void read_nrrd(Bytes bytes) {
    read_image(bytes, "image.nrrd");
}

void read_deflated(Bytes bytes) {
    constexpr std::size_t most = 1 << 24;
    const auto file = file_of(bytes, "data.gz");
    for (const Encoding encoding : {Encoding::deflated, Encoding::bare_deflated})
        refuse_or([&] {
            ByteStream stream(file, 0, encoding);
            std::array<char, 65536> buffer{};
            for (std::size_t done = 0; done < most;) {
                const std::size_t got = stream.read_some(buffer.data(), buffer.size());
                if (got == 0) break;
                done += got;
            }
        });
}

constexpr Reader all[] = {{"dicom_header", read_dicom_header_bytes},
                          {"dicom", read_dicom_slices},
                          {"rle", read_rle},
                          {"nifti", read_nifti},
                          {"meta", read_meta},
                          {"nrrd", read_nrrd},
                          {"deflated", read_deflated}};

}  // namespace

std::span<const Reader> image_readers() {
    return all;
}

}  // namespace hepatica::fuzz
