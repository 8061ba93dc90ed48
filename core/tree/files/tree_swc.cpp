// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes trees as SWC.
#include "core/tree/files/tree_io.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <sstream>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/base/patient_space.h"
#include "core/tree/extraction/line_graph.h"
#include "core/tree/files/tree_files.h"

namespace hepatica {

namespace {

// SWC leaves the meaning of types from 5 on to the writer, and 0 is undefined. They are read as
// systems only where the file contains this line.
constexpr const char* types_line = "# Types: 5 portal vein, 6 hepatic veins, 7 artery, 0 unknown.";
constexpr int type_before_portal = 4;

int type_of(VascularSystem system) {
    return system == VascularSystem::unknown ? 0 : type_before_portal + number_of(system);
}

VascularSystem system_of_type(double type) {
    for (const VascularSystem system : vascular_systems)
        if (type == type_of(system)) return system;
    return VascularSystem::unknown;
}

// The shortest text that reads back exactly, in any locale.
std::string text_of(double value) {
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    return {buffer, end};
}

struct Sample {
    long long number = 0;
    VascularSystem system = VascularSystem::unknown;
    Vec3 position_mm = Vec3::Zero();
    double radius_mm = 0.0;
    long long parent = -1;
};

// Reads the next number of a line; false where there is none.
template <class T>
bool take(std::string_view& line, T& value) {
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return false;
    line.remove_prefix(begin);
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), value);
    if (error != std::errc{}) return false;
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    return line.empty() || line.front() == ' ' || line.front() == '\t' || line.front() == '\r';
}

std::vector<Sample> parse_samples(const std::string& text, const std::filesystem::path& file) {
    std::vector<Sample> samples;
    const bool names_systems = text.find(types_line) != std::string::npos;
    std::istringstream lines(text);
    std::string line;
    for (int line_number = 1; std::getline(lines, line); ++line_number) {
        std::string_view rest(line);
        rest = rest.substr(0, rest.find('#'));
        if (rest.find_first_not_of(" \t\r") == std::string_view::npos) continue;
        Sample s;
        double type = 0.0;
        const bool whole = take(rest, s.number) && take(rest, type) &&
                           take(rest, s.position_mm.x()) && take(rest, s.position_mm.y()) &&
                           take(rest, s.position_mm.z()) && take(rest, s.radius_mm) &&
                           take(rest, s.parent);
        if (!whole)
            throw InputError("line " + std::to_string(line_number) + " is not a sample",
                             file.string(), "Give an SWC file: seven numbers per line");
        require_in_patient_space(s.position_mm, "sample " + std::to_string(s.number),
                                 file.string());
        if (names_systems) s.system = system_of_type(type);
        samples.push_back(s);
    }
    return samples;
}

// Throws InputError for a sample that is its own ancestor, because it has no root. `index_of` holds
// every sample and every named parent.
void refuse_cycles(const std::vector<Sample>& samples, const std::map<long long, int>& index_of,
                   const std::filesystem::path& file) {
    enum class Visit { none, under_way, done };
    std::vector<Visit> visits(samples.size(), Visit::none);
    for (std::size_t first = 0; first < samples.size(); ++first) {
        std::vector<std::size_t> way;
        std::size_t at = first;
        while (visits[at] == Visit::none) {
            visits[at] = Visit::under_way;
            way.push_back(at);
            if (samples[at].parent < 0) break;
            at = static_cast<std::size_t>(index_of.at(samples[at].parent));
        }
        if (visits[at] == Visit::under_way && samples[at].parent >= 0)
            throw InputError(
                "sample " + std::to_string(samples[at].number) + " is its own ancestor",
                file.string(), "Give a tree: each vessel must lead back to a root");
        for (const std::size_t sample : way) visits[sample] = Visit::done;
    }
}

}  // namespace

void write_tree_swc(const std::filesystem::path& file, const VesselTree& tree) {
    std::ostringstream out;
    out << "# Vessel tree, millimetres, LPS.\n"
        << types_line << "\n# number type x y z radius parent\n";
    long long number = 0;
    const auto write_sample = [&](const VesselSegment& s, std::size_t i, long long parent) {
        const Vec3& p = s.points_mm[i];
        out << ++number << ' ' << type_of(s.system) << ' ' << text_of(p.x()) << ' '
            << text_of(p.y()) << ' ' << text_of(p.z()) << ' ' << text_of(s.radii_mm[i]) << ' '
            << parent << '\n';
        return number;
    };
    std::vector<long long> last_sample(tree.segments.size());
    std::vector<long long> root_sample(tree.nodes.size(), -1);
    for (std::size_t id = 0; id < tree.segments.size(); ++id) {
        const VesselSegment& segment = tree.segments[id];
        long long& root = root_sample[segment.proximal_node];
        if (segment.parent < 0 && root < 0) root = write_sample(segment, 0, -1);
        long long before = segment.parent < 0 ? root : last_sample[segment.parent];
        for (std::size_t i = 1; i < segment.points_mm.size(); ++i)
            before = write_sample(segment, i, before);
        last_sample[id] = before;
    }
    write_text_atomically(file, out.str());
}

VesselTree read_tree_swc(const std::filesystem::path& file, const TreeFileFacts& facts) {
    const std::vector<Sample> samples = parse_samples(read_text(file), file);
    const Vec3 signs = signs_to_lps(facts.space.value_or(PatientSpace::lps));
    std::map<long long, int> index_of;
    std::vector<Vec3> points;
    for (const Sample& s : samples) {
        if (!index_of.try_emplace(s.number, static_cast<int>(points.size())).second)
            throw InputError("sample " + std::to_string(s.number) + " stands there twice",
                             file.string(), "Number the samples differently");
        points.push_back(signs.cwiseProduct(s.position_mm));
    }
    std::vector<LineEdge> edges;
    std::vector<int> root_points;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Sample& s = samples[i];
        if (s.parent < 0) {
            root_points.push_back(static_cast<int>(i));
            continue;
        }
        const auto parent = index_of.find(s.parent);
        if (parent == index_of.end())
            throw InputError("sample " + std::to_string(s.number) + " names a parent, " +
                                 std::to_string(s.parent) + ", that is not there",
                             file.string(), "Give the whole file");
        edges.push_back({parent->second, static_cast<int>(i), samples[parent->second].radius_mm,
                         s.radius_mm, s.system});
    }
    refuse_cycles(samples, index_of, file);
    if (edges.empty())
        throw InputError("holds no vessel", file.string(),
                         "Give an SWC file with two samples or more");
    LineGraph lines = graph_of_edges(points, edges, root_points);
    std::vector<RootWish> wishes;
    for (const int p : root_points) wishes.push_back({lines.node_of_point[p], samples[p].system});
    VesselTree tree = directed(std::move(lines.graph), wishes);
    validate_from_file(tree, file);
    return tree;
}

}  // namespace hepatica
