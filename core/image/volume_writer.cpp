// SPDX-License-Identifier: GPL-3.0-or-later
// NIfTI-1 headers by byte offset and NRRD headers as text.
#include "core/image/volume_writer.h"

#include <Eigen/Geometry>
#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <locale>
#include <sstream>
#include <vector>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/image/gzip.h"
#include "core/image/header_text.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

static_assert(std::endian::native == std::endian::little);

void require_written(std::ofstream& out, const fs::path& file) {
    out.close();
    if (!out)
        throw InputError("cannot be written to its end", file.string(),
                         "Check that the disk has free space and the folder may be written");
}

template <class T>
std::span<const std::byte> bytes_of_voxels(const Image<T>& image) {
    return std::as_bytes(std::span(image.voxels));
}

using NiftiHeader = std::array<std::byte, 352>;

template <class T>
void put(NiftiHeader& header, std::size_t offset, T value) {
    std::memcpy(header.data() + offset, &value, sizeof(T));
}

void put_float(NiftiHeader& header, std::size_t offset, double value) {
    put(header, offset, static_cast<float>(value));
}

// Writes both forms of the position: a quaternion (qform) and an affine map (sform).
void put_place(NiftiHeader& header, const Grid& grid) {
    const Vec3 to_ras(-1, -1, 1);
    const Mat3 direction = to_ras.asDiagonal() * grid.direction;
    const Vec3 origin = to_ras.cwiseProduct(grid.origin_mm);
    Mat3 rotation = direction;
    const bool mirrored = direction.determinant() < 0.0;
    if (mirrored) rotation.col(2) *= -1.0;
    const Eigen::Quaterniond q(rotation);
    const double sign = q.w() < 0.0 ? -1.0 : 1.0;
    put_float(header, 76, mirrored ? -1.0 : 1.0);
    put<std::int16_t>(header, 252, 1);  // scanner coordinates
    put<std::int16_t>(header, 254, 1);
    put_float(header, 256, sign * q.x());
    put_float(header, 260, sign * q.y());
    put_float(header, 264, sign * q.z());
    for (int i = 0; i < 3; ++i) {
        put_float(header, 268 + 4 * static_cast<std::size_t>(i), origin[i]);
        const std::size_t row = 280 + 16 * static_cast<std::size_t>(i);
        for (int j = 0; j < 3; ++j)
            put_float(header, row + 4 * static_cast<std::size_t>(j),
                      direction(i, j) * grid.spacing_mm[j]);
        put_float(header, row + 12, origin[i]);
    }
}

NiftiHeader nifti_header(const Grid& grid, std::int16_t datatype, std::int16_t bits) {
    NiftiHeader header{};
    put<std::int32_t>(header, 0, 348);
    put<std::int16_t>(header, 40, 3);
    for (std::size_t a = 0; a < 3; ++a) {
        put(header, 42 + 2 * a, static_cast<std::int16_t>(grid.dims[a]));
        put_float(header, 80 + 4 * a, grid.spacing_mm[static_cast<int>(a)]);
    }
    for (std::size_t a = 4; a < 8; ++a) {
        put<std::int16_t>(header, 40 + 2 * a, 1);
        put_float(header, 76 + 4 * a, 1.0);
    }
    put(header, 70, datatype);
    put(header, 72, bits);
    put_float(header, 108, 352.0);
    put_float(header, 112, 1.0);
    put<std::uint8_t>(header, 123, 2);  // millimetres
    put_place(header, grid);
    std::memcpy(header.data() + 344, "n+1", 4);
    return header;
}

template <class T>
void write_nifti_image(const fs::path& file, const Image<T>& image, std::int16_t datatype) {
    const std::string name = lower_case(file.filename().string());
    const bool gzip = name.ends_with(".nii.gz");
    if (!gzip && !name.ends_with(".nii"))
        throw InputError("does not end in .nii or .nii.gz", file.string(), "Choose such a name");
    for (const int n : image.grid.dims)
        if (n < 1 || n > 32767)
            throw InputError("cannot hold " + std::to_string(n) + " voxels along an axis",
                             file.string(), "Crop the image, or write .nrrd");
    const NiftiHeader header = nifti_header(image.grid, datatype, 8 * sizeof(T));
    write_file_atomically(file, [&](const fs::path& temporary) {
        std::ofstream out(temporary, std::ios::binary);
        const std::vector<std::span<const std::byte>> pieces{header, bytes_of_voxels(image)};
        if (gzip)
            write_gzip(out, pieces);
        else
            for (const auto piece : pieces)
                out.write(reinterpret_cast<const char*>(piece.data()),
                          static_cast<std::streamsize>(piece.size()));
        require_written(out, file);
    });
}

std::string vector_text(const Vec3& v) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(17);
    text << '(' << v[0] << ',' << v[1] << ',' << v[2] << ')';
    return text.str();
}

std::string segment_fields(const LabelMap& labels, const SegmentDescription& segment,
                           std::size_t number) {
    const std::string key = "Segment" + std::to_string(number) + "_";
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << key << "Color:=" << segment.colour[0] << ' ' << segment.colour[1] << ' '
         << segment.colour[2] << '\n'
         << key << "ColorAutoGenerated:=0\n"
         << key << "Extent:=0 " << labels.grid.dims[0] - 1 << " 0 " << labels.grid.dims[1] - 1
         << " 0 " << labels.grid.dims[2] - 1 << '\n'
         << key << "ID:=Segment_" << segment.label << '\n'
         << key << "LabelValue:=" << segment.label << '\n'
         << key << "Layer:=0\n"
         << key << "Name:=" << segment.name << '\n'
         << key << "NameAutoGenerated:=0\n"
         << key << "Tags:=|\n";
    return text.str();
}

std::string nrrd_header(const LabelMap& labels, std::span<const SegmentDescription> segments) {
    const Grid& grid = labels.grid;
    std::ostringstream text;
    text << "NRRD0004\ntype: unsigned short\ndimension: 3\nspace: left-posterior-superior\nsizes: "
         << grid.dims[0] << ' ' << grid.dims[1] << ' ' << grid.dims[2] << "\nspace directions:";
    for (int a = 0; a < 3; ++a)
        text << ' ' << vector_text(grid.direction.col(a) * grid.spacing_mm[a]);
    text << "\nkinds: domain domain domain\nendian: little\nencoding: gzip\nspace origin: "
         << vector_text(grid.origin_mm) << '\n';
    for (std::size_t i = 0; i < segments.size(); ++i)
        text << segment_fields(labels, segments[i], i);
    text << "Segmentation_ContainedRepresentationNames:=Binary labelmap|\n"
         << "Segmentation_MasterRepresentation:=Binary labelmap\n"
         << "Segmentation_ReferenceImageExtentOffset:=0 0 0\n\n";
    return text.str();
}

}  // namespace

void write_nifti(const fs::path& file, const Volume& volume) {
    write_nifti_image(file, volume, 4);
}
void write_nifti(const fs::path& file, const FloatVolume& volume) {
    write_nifti_image(file, volume, 16);
}
void write_nifti(const fs::path& file, const Mask& mask) {
    write_nifti_image(file, mask, 2);
}
void write_nifti(const fs::path& file, const LabelMap& labels) {
    write_nifti_image(file, labels, 512);
}

void write_segmentation(const fs::path& file, const LabelMap& labels,
                        std::span<const SegmentDescription> segments) {
    if (!lower_case(file.filename().string()).ends_with(".seg.nrrd"))
        throw InputError("does not end in .seg.nrrd", file.string(), "Choose such a name");
    const std::string header = nrrd_header(labels, segments);
    write_file_atomically(file, [&](const fs::path& temporary) {
        std::ofstream out(temporary, std::ios::binary);
        out.write(header.data(), static_cast<std::streamsize>(header.size()));
        write_gzip(out, {bytes_of_voxels(labels)});
        require_written(out, file);
    });
}

}  // namespace hepatica
