// SPDX-License-Identifier: GPL-3.0-or-later
// Header of MetaImage (.mha, .mhd with its .raw or .zraw); positions in LPS as ITK writes them.
#include <fstream>
#include <map>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/image/header_text.h"
#include "core/image/voxel_file.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void reject(const fs::path& file, const std::string& what) {
    throw InputError(what, file.string(), "Export the image again as one three-dimensional volume");
}

using Fields = std::map<std::string, std::string>;

// ElementDataFile is the last field; the data may follow it.
Fields read_fields(std::ifstream& in, const fs::path& file) {
    Fields fields;
    for (std::string line; std::getline(in, line);) {
        const std::size_t equals = line.find('=');
        if (equals == std::string::npos || in.tellg() > (1 << 20)) break;
        const std::string name = lower_case(trimmed(line.substr(0, equals)));
        fields[name] = trimmed(line.substr(equals + 1));
        if (name == "elementdatafile") return fields;
    }
    if (in.bad()) throw InputError("cannot be read to its end", file.string(), "Check the disk");
    reject(file, "is not a MetaImage (it names no ElementDataFile)");
}

std::string field(const Fields& fields, const std::string& name) {
    const auto found = fields.find(name);
    return found == fields.end() ? "" : found->second;
}

std::optional<ScalarType> scalar_type(const std::string& name) {
    static const std::map<std::string, ScalarType> types{
        {"MET_CHAR", ScalarType::int8},       {"MET_UCHAR", ScalarType::uint8},
        {"MET_SHORT", ScalarType::int16},     {"MET_USHORT", ScalarType::uint16},
        {"MET_INT", ScalarType::int32},       {"MET_UINT", ScalarType::uint32},
        {"MET_LONG_LONG", ScalarType::int64}, {"MET_ULONG_LONG", ScalarType::uint64},
        {"MET_LONG", ScalarType::int32},      {"MET_ULONG", ScalarType::uint32},
        {"MET_FLOAT", ScalarType::float32},   {"MET_DOUBLE", ScalarType::float64}};
    const auto found = types.find(name);
    if (found == types.end()) return std::nullopt;
    return found->second;
}

std::vector<double> values_of(const Fields& fields, std::initializer_list<const char*> names,
                              std::size_t count, const fs::path& file) {
    for (const char* name : names) {
        const std::string text = field(fields, name);
        if (text.empty()) continue;
        const auto values = numbers(text);
        if (!values || values->size() != count)
            reject(file, std::string("has ") + name + " = " + text);
        return *values;
    }
    return {};
}

bool is_true(const std::string& text) {
    return lower_case(text).starts_with('t') || text.starts_with('1');
}

void place(const Fields& fields, VoxelFile& file, const fs::path& path) {
    const std::vector<double> sizes = values_of(fields, {"dimsize"}, 3, path);
    const std::vector<double> spacing =
        values_of(fields, {"elementspacing", "elementsize"}, 3, path);
    const std::vector<double> origin = values_of(fields, {"offset", "origin", "position"}, 3, path);
    const std::vector<double> matrix =
        values_of(fields, {"transformmatrix", "rotation", "orientation"}, 9, path);
    if (sizes.empty()) reject(path, "has no DimSize");
    if (spacing.empty()) reject(path, "has no ElementSpacing");
    for (std::size_t a = 0; a < 3; ++a) {
        if (!(sizes[a] >= 1 && sizes[a] < 1e12)) reject(path, "has a DimSize that is no size");
        file.dims[a] = static_cast<std::int64_t>(sizes[a]);
        const int i = static_cast<int>(a);
        if (!(spacing[a] > 0.0))
            reject(path, "has a voxel spacing of " + number_text(spacing[a]) + " mm");
        if (!matrix.empty())
            file.axes.col(i) = Vec3(matrix[3 * a], matrix[3 * a + 1], matrix[3 * a + 2]);
        file.axes.col(i) *= spacing[a];
        if (!origin.empty()) file.origin_mm[i] = origin[a];
    }
}

}  // namespace

VoxelFile read_meta_header(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    const Fields fields = read_fields(in, path);
    const std::streamoff end = in.tellg();
    VoxelFile file;
    file.header_file = path;
    if (field(fields, "ndims") != "3")
        reject(path, "has " + field(fields, "ndims") + " dimensions, not 3");
    const std::string channels = field(fields, "elementnumberofchannels");
    if (!channels.empty() && channels != "1") reject(path, "has " + channels + " values a voxel");
    const std::optional<ScalarType> type = scalar_type(field(fields, "elementtype"));
    if (!type) reject(path, "has voxels of type \"" + field(fields, "elementtype") + "\"");
    file.type = *type;
    file.big_endian = is_true(field(fields, "binarydatabyteordermsb")) ||
                      is_true(field(fields, "elementbyteordermsb"));
    const std::string binary = field(fields, "binarydata");
    if (!binary.empty() && !is_true(binary))
        reject(path, "holds its voxels as text (BinaryData = False)");
    if (is_true(field(fields, "compresseddata"))) file.encoding = Encoding::deflated;
    const std::string data = field(fields, "elementdatafile");
    if (lower_case(data) == "local") {
        file.data_file = path;
        file.data_offset = static_cast<std::uint64_t>(end);
    } else if (data == "LIST" || data.find('%') != std::string::npos) {
        reject(path, "has its data in several files");
    } else {
        file.data_file = path.parent_path() / data;
    }
    if (!field(fields, "headersize").empty() && field(fields, "headersize") != "0")
        reject(path, "has a data file with a header of its own");
    place(fields, file, path);
    return file;
}

}  // namespace hepatica
