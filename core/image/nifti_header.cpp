// SPDX-License-Identifier: GPL-3.0-or-later
// Header of NIfTI-1 and NIfTI-2 (https://nifti.nimh.nih.gov), single file, both byte orders.
// Positions on disk are RAS, so x and y change sign.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/image/voxel_file.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void reject_nifti(const fs::path& file, const std::string& what) {
    throw InputError(what, file.string(), "Choose a NIfTI file that another viewer opens");
}

// Fields by their offset in the header, in the file's byte order.
class HeaderBytes {
  public:
    HeaderBytes(const std::array<unsigned char, 544>& bytes, bool swap)
        : bytes_(bytes), swap_(swap) {}

    template <class T>
    T get(std::size_t offset) const {
        std::array<unsigned char, sizeof(T)> raw;
        std::memcpy(raw.data(), bytes_.data() + offset, sizeof(T));
        if (swap_) std::reverse(raw.begin(), raw.end());
        return std::bit_cast<T>(raw);
    }

  private:
    const std::array<unsigned char, 544>& bytes_;
    bool swap_;
};

// The fields that both versions share.
struct Nifti {
    std::array<std::int64_t, 8> dim{};
    std::array<double, 8> pixdim{};
    int datatype = 0;
    double slope = 0.0;
    double intercept = 0.0;
    double data_offset = 0.0;
    int units = 0;
    int qform = 0;
    int sform = 0;
    std::array<double, 3> quaternion{};
    Vec3 quaternion_offset = Vec3::Zero();
    std::array<std::array<double, 4>, 3> affine{};
};

Nifti parse_version_1(const HeaderBytes& h) {
    Nifti n;
    for (std::size_t i = 0; i < 8; ++i) {
        n.dim[i] = h.get<std::int16_t>(40 + 2 * i);
        n.pixdim[i] = h.get<float>(76 + 4 * i);
    }
    n.datatype = h.get<std::int16_t>(70);
    n.data_offset = h.get<float>(108);
    n.slope = h.get<float>(112);
    n.intercept = h.get<float>(116);
    n.units = h.get<std::uint8_t>(123);
    n.qform = h.get<std::int16_t>(252);
    n.sform = h.get<std::int16_t>(254);
    for (std::size_t i = 0; i < 3; ++i) {
        n.quaternion[i] = h.get<float>(256 + 4 * i);
        n.quaternion_offset[static_cast<int>(i)] = h.get<float>(268 + 4 * i);
        for (std::size_t j = 0; j < 4; ++j) n.affine[i][j] = h.get<float>(280 + 16 * i + 4 * j);
    }
    return n;
}

Nifti parse_version_2(const HeaderBytes& h) {
    Nifti n;
    for (std::size_t i = 0; i < 8; ++i) {
        n.dim[i] = h.get<std::int64_t>(16 + 8 * i);
        n.pixdim[i] = h.get<double>(104 + 8 * i);
    }
    n.datatype = h.get<std::int16_t>(12);
    n.data_offset = static_cast<double>(h.get<std::int64_t>(168));
    n.slope = h.get<double>(176);
    n.intercept = h.get<double>(184);
    n.qform = h.get<std::int32_t>(344);
    n.sform = h.get<std::int32_t>(348);
    for (std::size_t i = 0; i < 3; ++i) {
        n.quaternion[i] = h.get<double>(352 + 8 * i);
        n.quaternion_offset[static_cast<int>(i)] = h.get<double>(376 + 8 * i);
        for (std::size_t j = 0; j < 4; ++j) n.affine[i][j] = h.get<double>(400 + 32 * i + 8 * j);
    }
    n.units = h.get<std::int32_t>(500);
    return n;
}

std::optional<ScalarType> scalar_type(int datatype) {
    switch (datatype) {
        case 2:
            return ScalarType::uint8;
        case 4:
            return ScalarType::int16;
        case 8:
            return ScalarType::int32;
        case 16:
            return ScalarType::float32;
        case 64:
            return ScalarType::float64;
        case 256:
            return ScalarType::int8;
        case 512:
            return ScalarType::uint16;
        case 768:
            return ScalarType::uint32;
        case 1024:
            return ScalarType::int64;
        case 1280:
            return ScalarType::uint64;
        default:
            return std::nullopt;
    }
}

void place_by_affine(const Nifti& n, VoxelFile& file) {
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) file.axes(i, j) = n.affine[i][j];
        file.origin_mm[i] = n.affine[i][3];
    }
}

void place_by_quaternion(const Nifti& n, VoxelFile& file) {
    const auto [b, c, d] = n.quaternion;
    const double a = std::sqrt(std::max(0.0, 1.0 - (b * b + c * c + d * d)));
    const Mat3 rotation = Eigen::Quaterniond(a, b, c, d).normalized().toRotationMatrix();
    for (int j = 0; j < 3; ++j) file.axes.col(j) = rotation.col(j) * n.pixdim[j + 1];
    if (n.pixdim[0] < 0.0) file.axes.col(2) *= -1.0;
    file.origin_mm = n.quaternion_offset;
}

// Without qform and sform the standard leaves the orientation open; RAS is what its tools assume.
void place(const Nifti& n, VoxelFile& file) {
    if (n.sform > 0)
        place_by_affine(n, file);
    else if (n.qform > 0)
        place_by_quaternion(n, file);
    else
        file.axes = Vec3(n.pixdim[1], n.pixdim[2], n.pixdim[3]).asDiagonal();
    file.orientation_assumed = n.sform <= 0 && n.qform <= 0;
    const int space_units = n.units & 7;
    const double millimetres = space_units == 1 ? 1000.0 : space_units == 3 ? 0.001 : 1.0;
    const Vec3 lps = Vec3(-1.0, -1.0, 1.0) * millimetres;
    file.axes = lps.asDiagonal() * file.axes;
    file.origin_mm = lps.cwiseProduct(file.origin_mm);
}

void check_pixdim(const Nifti& n, const fs::path& file) {
    for (int a = 1; a <= 3; ++a)
        if (!std::isfinite(n.pixdim[a]) || n.pixdim[a] <= 0.0)
            reject_nifti(file, "has a voxel spacing of " + number_text(n.pixdim[a]) + " mm");
}

}  // namespace

VoxelFile read_nifti_header(const fs::path& path) {
    VoxelFile file;
    file.header_file = file.data_file = path;
    std::array<unsigned char, 2> mark{};
    {
        ByteStream raw(path, 0, Encoding::raw);
        raw.read_some(mark.data(), mark.size());
    }
    const bool gzip = mark[0] == 0x1f && mark[1] == 0x8b;
    file.encoding = gzip ? Encoding::deflated : Encoding::raw;

    std::array<unsigned char, 544> bytes{};
    ByteStream stream(path, 0, file.encoding);
    const std::size_t got = stream.read_some(bytes.data(), bytes.size());
    if (got < 348) reject_nifti(path, "is too short to be a NIfTI image");
    const HeaderBytes native(bytes, false);
    const HeaderBytes swapped(bytes, true);
    const auto is_size = [](std::int32_t size) { return size == 348 || size == 540; };
    if (!is_size(native.get<std::int32_t>(0)) && !is_size(swapped.get<std::int32_t>(0)))
        reject_nifti(path, "is not a NIfTI image");
    const bool swap = !is_size(native.get<std::int32_t>(0));
    const HeaderBytes& h = swap ? swapped : native;
    const bool version_2 = h.get<std::int32_t>(0) == 540;
    if (version_2 && got < 540) reject_nifti(path, "is cut within its NIfTI-2 header");
    const char* magic = reinterpret_cast<const char*>(bytes.data()) + (version_2 ? 4 : 344);
    if (std::strncmp(magic, "ni", 2) == 0)
        reject_nifti(path, "is the header of a two-file NIfTI image (.hdr and .img)");
    if (std::strncmp(magic, "n+", 2) != 0)
        reject_nifti(path, "is an Analyze image, which does not say left from right");
    const Nifti n = version_2 ? parse_version_2(h) : parse_version_1(h);

    if (n.dim[0] < 3 || n.dim[0] > 7)
        reject_nifti(path, "has " + std::to_string(n.dim[0]) + " dimensions, not 3");
    for (std::int64_t i = 4; i <= n.dim[0]; ++i)
        if (n.dim[static_cast<std::size_t>(i)] > 1)
            reject_nifti(path, "holds several volumes (a time series or vectors)");
    file.dims = {n.dim[1], n.dim[2], n.dim[3]};
    const std::optional<ScalarType> type = scalar_type(n.datatype);
    if (!type) reject_nifti(path, "has voxels of NIfTI type " + std::to_string(n.datatype));
    file.type = *type;
    file.big_endian = swap != (std::endian::native == std::endian::big);
    if (!(n.data_offset >= (version_2 ? 540 : 348)) || n.data_offset > 1e8)
        reject_nifti(path, "has a data offset of " + number_text(n.data_offset));
    if (gzip)
        file.skip_bytes = static_cast<std::uint64_t>(n.data_offset);
    else
        file.data_offset = static_cast<std::uint64_t>(n.data_offset);
    if (n.slope != 0.0 && std::isfinite(n.slope)) {
        file.slope = n.slope;
        file.intercept = std::isfinite(n.intercept) ? n.intercept : 0.0;
    }
    check_pixdim(n, path);
    place(n, file);
    return file;
}

}  // namespace hepatica
