// SPDX-License-Identifier: GPL-3.0-or-later
// Header of NRRD (https://teem.sourceforge.net/nrrd/format.html), including 3D Slicer's .seg.nrrd:
// one three-dimensional volume, raw or gzip, data after the header or in one separate file.
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/image/header_text.h"
#include "core/image/voxel_file.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void reject_nrrd(const fs::path& file, const std::string& what) {
    throw InputError(what, file.string(), "Export the image again as one volume, raw or gzip");
}

using Fields = std::map<std::string, std::string>;

// Field names in lower case. Afterwards the stream is positioned after the blank line.
Fields read_fields(std::ifstream& in, const fs::path& file) {
    Fields fields;
    std::string line;
    std::getline(in, line);
    while (std::getline(in, line)) {
        line = trimmed(line);
        if (line.empty()) return fields;
        const std::size_t colon = line.find(':');
        if (line[0] == '#' || colon == std::string::npos) continue;
        const bool is_key = colon + 1 < line.size() && line[colon + 1] == '=';
        if (is_key) continue;  // free key := value pairs
        fields[lower_case(line.substr(0, colon))] = trimmed(line.substr(colon + 1));
        if (in.tellg() > (1 << 24)) reject_nrrd(file, "has a header without an end");
    }
    if (in.bad()) throw InputError("cannot be read to its end", file.string(), "Check the disk");
    return fields;
}

std::string field(const Fields& fields, const std::string& name) {
    const auto found = fields.find(name);
    return found == fields.end() ? "" : found->second;
}

std::optional<ScalarType> scalar_type(const std::string& name) {
    static const std::map<std::string, ScalarType> types{
        {"signed char", ScalarType::int8},    {"int8", ScalarType::int8},
        {"int8_t", ScalarType::int8},         {"uchar", ScalarType::uint8},
        {"unsigned char", ScalarType::uint8}, {"uint8", ScalarType::uint8},
        {"uint8_t", ScalarType::uint8},       {"short", ScalarType::int16},
        {"short int", ScalarType::int16},     {"signed short", ScalarType::int16},
        {"int16", ScalarType::int16},         {"int16_t", ScalarType::int16},
        {"ushort", ScalarType::uint16},       {"unsigned short", ScalarType::uint16},
        {"uint16", ScalarType::uint16},       {"uint16_t", ScalarType::uint16},
        {"int", ScalarType::int32},           {"signed int", ScalarType::int32},
        {"int32", ScalarType::int32},         {"int32_t", ScalarType::int32},
        {"uint", ScalarType::uint32},         {"unsigned int", ScalarType::uint32},
        {"uint32", ScalarType::uint32},       {"uint32_t", ScalarType::uint32},
        {"longlong", ScalarType::int64},      {"long long", ScalarType::int64},
        {"int64", ScalarType::int64},         {"int64_t", ScalarType::int64},
        {"ulonglong", ScalarType::uint64},    {"unsigned long long", ScalarType::uint64},
        {"uint64", ScalarType::uint64},       {"uint64_t", ScalarType::uint64},
        {"float", ScalarType::float32},       {"double", ScalarType::float64}};
    const auto found = types.find(lower_case(name));
    if (found == types.end()) return std::nullopt;
    return found->second;
}

// "(1,0,0)": three numbers.
std::optional<Vec3> vector_of(std::string text) {
    for (char& c : text)
        if (c == '(' || c == ')' || c == ',') c = ' ';
    const auto values = numbers(text);
    if (!values || values->size() != 3) return std::nullopt;
    return Vec3((*values)[0], (*values)[1], (*values)[2]);
}

// "(1,0,0) (0, 1,0) (0,0,1)": one string per vector.
std::vector<std::string> vectors_in(const std::string& text) {
    std::vector<std::string> parts;
    for (std::size_t at = 0; (at = text.find('(', at)) != std::string::npos;) {
        const std::size_t end = text.find(')', at);
        if (end == std::string::npos) break;
        parts.push_back(text.substr(at, end - at + 1));
        at = end;
    }
    return parts;
}

// Signs that convert the file's space to LPS.
Vec3 to_lps(const std::string& space, const fs::path& file) {
    const std::string name = lower_case(space);
    if (name == "left-posterior-superior" || name == "lps") return {1, 1, 1};
    if (name == "right-anterior-superior" || name == "ras") return {-1, -1, 1};
    if (name == "left-anterior-superior" || name == "las") return {1, -1, 1};
    if (name.empty())
        reject_nrrd(file,
                    "does not say which way its axes run in the patient (no \"space\" field)");
    reject_nrrd(file, "has its axes in space \"" + space + "\"");
}

void place(const Fields& fields, VoxelFile& file, const fs::path& path) {
    const Vec3 signs = to_lps(field(fields, "space"), path);
    const std::vector<std::string> directions = vectors_in(field(fields, "space directions"));
    if (directions.size() != 3) reject_nrrd(path, "does not have three space directions");
    for (int a = 0; a < 3; ++a) {
        const std::optional<Vec3> axis = vector_of(directions[static_cast<std::size_t>(a)]);
        if (!axis) reject_nrrd(path, "has a space direction that is not three numbers");
        file.axes.col(a) = signs.cwiseProduct(*axis);
    }
    const std::optional<Vec3> origin = vector_of(field(fields, "space origin"));
    if (!origin) reject_nrrd(path, "has no space origin");
    file.origin_mm = signs.cwiseProduct(*origin);
}

void read_sizes(const Fields& fields, VoxelFile& file, const fs::path& path) {
    const auto sizes = numbers(field(fields, "sizes"));
    const std::string dimension = field(fields, "dimension");
    if (dimension == "4" && field(fields, "kinds").starts_with("list"))
        reject_nrrd(path,
                    "holds overlapping segments in layers; export a segmentation whose segments "
                    "do not overlap, or a label map");
    if (dimension != "3" || !sizes || sizes->size() != 3)
        reject_nrrd(path, "has " + dimension + " dimensions, not 3");
    for (std::size_t a = 0; a < 3; ++a) {
        if (!((*sizes)[a] >= 1 && (*sizes)[a] < 1e12))
            reject_nrrd(path, "has a size that is no size");
        file.dims[a] = static_cast<std::int64_t>((*sizes)[a]);
    }
}

void find_data(const Fields& fields, VoxelFile& file, const fs::path& path,
               std::uint64_t header_end) {
    std::string data = field(fields, "data file");
    if (data.empty()) data = field(fields, "datafile");
    if (data.empty()) {
        // Without the blank line that ends it, the header itself would be read as voxels.
        if (header_end == 0) reject_nrrd(path, "has a header without an end");
        file.data_file = path;
        file.data_offset = header_end;
    } else {
        if (data.starts_with("LIST") || data.find('%') != std::string::npos)
            reject_nrrd(path, "has its data in several files");
        file.data_file = path.parent_path() / data;
    }
    const std::string encoding = lower_case(field(fields, "encoding"));
    if (encoding == "gzip" || encoding == "gz")
        file.encoding = Encoding::deflated;
    else if (encoding != "raw")
        reject_nrrd(path, "has encoding \"" + encoding + "\"");
    for (const char* name : {"byte skip", "byteskip", "line skip", "lineskip"}) {
        const std::string skip = field(fields, name);
        if (!skip.empty() && skip != "0") reject_nrrd(path, "skips bytes before its data");
    }
}

}  // namespace

VoxelFile read_nrrd_header(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    const Fields fields = read_fields(in, path);
    const std::streamoff end = in ? std::streamoff(in.tellg()) : 0;
    VoxelFile file;
    file.header_file = path;
    read_sizes(fields, file, path);
    const std::optional<ScalarType> type = scalar_type(field(fields, "type"));
    if (!type) reject_nrrd(path, "has voxels of type \"" + field(fields, "type") + "\"");
    file.type = *type;
    file.big_endian = lower_case(field(fields, "endian")) == "big";
    find_data(fields, file, path, static_cast<std::uint64_t>(end));
    place(fields, file, path);
    return file;
}

}  // namespace hepatica
