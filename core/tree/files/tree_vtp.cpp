// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes trees as VTP.
#include "core/tree/files/tree_io.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <span>
#include <string_view>
#include <system_error>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/base/patient_space.h"
#include "core/tree/extraction/line_graph.h"
#include "core/tree/files/tree_files.h"
#include "core/tree/files/vtk_errors.h"
#include "core/tree/files/vtk_file.h"

namespace hepatica {

namespace {

vtkIntArray* add_ints(vtkFieldData* data, const char* name) {
    vtkNew<vtkIntArray> array;
    array->SetName(name);
    data->AddArray(array);
    return array;  // kept alive by data
}

vtkDoubleArray* add_doubles(vtkFieldData* data, const char* name) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    data->AddArray(array);
    return array;
}

// Position of a segment in its tree.
struct Place {
    int tree = 0;           // number of its tree, in the order of roots
    int depth = 0;          // number of segments between the root and its beginning
    double start_mm = 0.0;  // distance along the vessels from the root to its beginning
};

std::vector<Place> places_of(const VesselTree& tree) {
    std::vector<Place> places(tree.segments.size());
    int trees = 0;
    for (std::size_t s = 0; s < places.size(); ++s) {
        const int parent = tree.segments[s].parent;
        if (parent < 0) {
            places[s].tree = trees++;
            continue;
        }
        places[s] = {places[parent].tree, places[parent].depth + 1,
                     places[parent].start_mm + length_mm(tree.segments[parent])};
    }
    return places;
}

void add_points(const VesselTree& tree, const std::vector<Place>& places, vtkPolyData* lines) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> cells;
    vtkPointData* data = lines->GetPointData();
    auto* inscribed = add_doubles(data, "MaximumInscribedSphereRadius");
    auto* radius = add_doubles(data, "Radius");
    auto* path = add_doubles(data, "Path");
    auto* area = add_doubles(data, "CenterlineSectionArea");
    auto* branch = add_ints(data, "BranchId");
    auto* bifurcation = add_ints(data, "BifurcationId");
    auto* centreline = add_ints(data, "CenterlineId");
    auto* bridged = add_ints(data, "Bridged");
    const std::vector<int> degrees = node_degrees(tree);
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        const VesselSegment& segment = tree.segments[s];
        const std::size_t last = segment.points_mm.size() - 1;
        double along_mm = places[s].start_mm;
        cells->InsertNextCell(static_cast<int>(last) + 1);
        for (std::size_t i = 0; i <= last; ++i) {
            if (i > 0) along_mm += (segment.points_mm[i] - segment.points_mm[i - 1]).norm();
            cells->InsertCellPoint(points->InsertNextPoint(segment.points_mm[i].data()));
            const double r = segment.radii_mm[i];
            const int node = i == 0 ? segment.proximal_node : i == last ? segment.distal_node : -1;
            const bool at_bifurcation = node >= 0 && degrees[node] >= 3;
            inscribed->InsertNextValue(r);
            radius->InsertNextValue(r);
            path->InsertNextValue(along_mm);
            area->InsertNextValue(std::numbers::pi * r * r);
            branch->InsertNextValue(at_bifurcation ? -1 : static_cast<int>(s));
            bifurcation->InsertNextValue(at_bifurcation ? node : -1);
            centreline->InsertNextValue(places[s].tree);
            bridged->InsertNextValue(segment.bridged.empty() ? 0 : segment.bridged[i]);
        }
    }
    lines->SetPoints(points);
    lines->SetLines(cells);
}

void add_segments(const VesselTree& tree, const std::vector<Place>& places, vtkPolyData* lines) {
    vtkCellData* data = lines->GetCellData();
    auto* id = add_ints(data, "SegmentId");
    auto* parent = add_ints(data, "ParentId");
    auto* system = add_ints(data, "System");
    vtkNew<vtkStringArray> system_name;
    system_name->SetName("SystemName");
    data->AddArray(system_name);
    auto* confidence = add_doubles(data, "Confidence");
    auto* order = add_ints(data, "StrahlerOrder");
    auto* loop = add_ints(data, "ClosesLoop");
    auto* proximal = add_ints(data, "ProximalNode");
    auto* distal = add_ints(data, "DistalNode");
    auto* group = add_ints(data, "GroupIds");
    auto* centreline = add_ints(data, "CenterlineIds");
    auto* tract = add_ints(data, "TractIds");
    auto* blanking = add_ints(data, "Blanking");
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        const VesselSegment& segment = tree.segments[s];
        id->InsertNextValue(static_cast<int>(s));
        parent->InsertNextValue(segment.parent);
        system->InsertNextValue(number_of(segment.system));
        system_name->InsertNextValue(name_of(segment.system));
        confidence->InsertNextValue(segment.system_confidence);
        order->InsertNextValue(segment.strahler_order);
        loop->InsertNextValue(segment.closes_loop ? 1 : 0);
        proximal->InsertNextValue(segment.proximal_node);
        distal->InsertNextValue(segment.distal_node);
        group->InsertNextValue(static_cast<int>(s));
        centreline->InsertNextValue(places[s].tree);
        tract->InsertNextValue(places[s].depth);
        blanking->InsertNextValue(0);
    }
}

void add_field_data(const VesselTree& tree, vtkPolyData* lines) {
    vtkNew<vtkStringArray> space;
    space->SetName("SPACE");
    space->InsertNextValue("LPS");
    lines->GetFieldData()->AddArray(space);
    auto* radii = add_doubles(lines->GetFieldData(), "NodeRadius");
    for (const VesselNode& node : tree.nodes) radii->InsertNextValue(node.radius_mm);
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& problem) {
    throw InputError(problem, file.string(),
                     "Give a VTP file with the centrelines of vessels as lines");
}

// The lines of a file; each array has one value per point or cell.
struct Lines {
    VtkFile file;
    std::size_t first_cell;  // cell data count vertices before lines
    VtkCells cells;
    std::vector<Vec3> points_mm;  // LPS

    explicit Lines(const std::filesystem::path& path)
        : file(path, "PolyData"),
          first_cell(file.cell_count("Verts")),
          cells(file.cells("Lines")),
          points_mm(file.points()) {
        if (cells.size() == 0) refuse(path, "holds no lines");
    }
};

// The field data SPACE: "LPS", "RAS", or 3D Slicer's "SPACE=RAS"; "" where it is missing.
std::string stated_space(const VtkFile& file) {
    const auto space = file.texts("FieldData", "SPACE");
    if (!space || space->empty()) return "";
    const std::string& text = space->front();
    return text.starts_with("SPACE=") ? text.substr(6) : text;
}

PatientSpace space_of(const Lines& lines, const TreeFileFacts& facts,
                      const std::filesystem::path& file) {
    const std::string stated = stated_space(lines.file);
    if (stated.empty()) {
        if (facts.space) return *facts.space;
        throw InputError(
            "does not say which way its axes run (it has no field data SPACE)", file.string(),
            "State it, --tree-space lps or --tree-space ras, or save the tree from 3D Slicer, "
            "which writes SPACE");
    }
    if (stated != "LPS" && stated != "RAS")
        throw InputError("has its axes in space \"" + stated + "\"", file.string(),
                         "Save it in LPS or RAS");
    const PatientSpace space = stated == "RAS" ? PatientSpace::ras : PatientSpace::lps;
    if (facts.space && *facts.space != space)
        throw InputError("says itself that its axes are " + stated, file.string(),
                         "Leave --tree-space out");
    return space;
}

constexpr std::array own_arrays{"SegmentId",  "ParentId",     "System",    "StrahlerOrder",
                                "ClosesLoop", "ProximalNode", "DistalNode"};

bool is_own(const VtkFile& file) {
    const std::vector<std::string> names = file.names_of_numbers("CellData");
    return std::ranges::all_of(
               own_arrays,
               [&](const char* name) { return std::ranges::find(names, name) != names.end(); }) &&
           file.has("FieldData", "NodeRadius") && file.has("PointData", "Radius");
}

// A number of a file as int; a value beyond int becomes one that no tree uses.
int whole(double value) {
    constexpr int none = std::numeric_limits<int>::min();
    return std::abs(value) < 2e9 ? static_cast<int>(value) : none;
}

void require_known_systems(const VtkFile& file, const std::filesystem::path& path) {
    if (file.has("CellData", "SystemName")) return;
    const auto systems = file.numbers("CellData", "System");
    std::vector<int> numbers;
    std::ranges::transform(*systems, std::back_inserter(numbers), whole);
    require_unambiguous_systems(numbers, path);
}

VesselTree own_tree(const Lines& lines, const std::filesystem::path& path) {
    const auto node_radii = lines.file.numbers("FieldData", "NodeRadius");
    const auto radii = lines.file.numbers("PointData", "Radius");
    const auto bridged = lines.file.numbers("PointData", "Bridged");       // may be missing
    const auto confidence = lines.file.numbers("CellData", "Confidence");  // may be missing
    if (!node_radii || !radii) refuse(path, "holds radii that are not one number each");
    std::map<std::string_view, std::vector<double>> values;
    for (const char* name : own_arrays) values[name] = *lines.file.numbers("CellData", name);
    VesselTree tree;
    tree.nodes.resize(node_radii->size());
    for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
        const double radius_mm = (*node_radii)[n];
        if (!(radius_mm >= 0.0 && std::isfinite(radius_mm)))
            require_plausible_radius(radius_mm, "a node", path.string());
        tree.nodes[n].radius_mm = radius_mm;
    }
    for (std::size_t line = 0; line < lines.cells.size(); ++line) {
        const std::size_t cell = lines.first_cell + line;
        const auto value = [&](const char* name) { return whole(values.at(name)[cell]); };
        if (value("SegmentId") != static_cast<int>(tree.segments.size()))
            refuse(path, "its segments are not in the order of SegmentId");
        VesselSegment segment;
        segment.parent = value("ParentId");
        segment.system = system_numbered(value("System")).value_or(VascularSystem::unknown);
        if (confidence) segment.system_confidence = (*confidence)[cell];
        segment.strahler_order = value("StrahlerOrder");
        segment.closes_loop = value("ClosesLoop") != 0;
        segment.proximal_node = value("ProximalNode");
        segment.distal_node = value("DistalNode");
        for (const int id : lines.cells[line]) {
            segment.points_mm.push_back(lines.points_mm[id]);
            segment.radii_mm.push_back((*radii)[id]);
            segment.bridged.push_back(bridged && (*bridged)[id] != 0.0 ? 1 : 0);
        }
        if (std::ranges::count(segment.bridged, 1) == 0) segment.bridged.clear();
        tree.segments.push_back(std::move(segment));
    }
    validate_from_file(tree, path);  // the node numbers are used below
    for (const VesselSegment& segment : tree.segments) {
        tree.nodes[segment.proximal_node].position_mm = segment.points_mm.front();
        tree.nodes[segment.distal_node].position_mm = segment.points_mm.back();
    }
    return tree;
}

// The first array with "radius" in its name.
std::optional<std::vector<double>> radii_in(const VtkFile& file, const char* data) {
    for (const std::string& name : file.names_of_numbers(data)) {
        std::string small = name;
        std::ranges::transform(small, small.begin(),
                               [](unsigned char c) { return std::tolower(c); });
        if (small.find("radius") != std::string::npos) return file.numbers(data, name);
    }
    return std::nullopt;
}

// The radius at a point of a line: from an array, or as stated by the user.
class Radii {
  public:
    Radii(const VtkFile& file, const TreeFileFacts& facts, const std::filesystem::path& path)
        : at_points_(radii_in(file, "PointData")), stated_mm_(facts.radius_mm) {
        if (!at_points_) at_cells_ = radii_in(file, "CellData");
        const bool in_file = at_points_ || at_cells_;
        if (!in_file && !stated_mm_)
            throw InputError(
                "holds no radii", path.string(),
                "Give the lines a point or cell array MaximumInscribedSphereRadius or Radius [mm], "
                "or state one radius for all vessels: --radius-mm");
        if (in_file && stated_mm_)
            throw InputError("holds radii of its own", path.string(), "Leave --radius-mm out");
    }
    double at(std::size_t cell, int point) const {
        if (at_points_) return (*at_points_)[point];
        return at_cells_ ? (*at_cells_)[cell] : *stated_mm_;
    }

  private:
    std::optional<std::vector<double>> at_points_;
    std::optional<std::vector<double>> at_cells_;
    std::optional<double> stated_mm_;
};

VesselTree foreign_tree(const Lines& lines, const TreeFileFacts& facts,
                        const std::filesystem::path& path) {
    for (const Vec3& point : lines.points_mm)
        require_in_patient_space(point, "a point", path.string());
    const Radii radii(lines.file, facts, path);
    std::vector<LineEdge> edges;
    for (std::size_t line = 0; line < lines.cells.size(); ++line) {
        const std::size_t cell = lines.first_cell + line;
        const std::span<const int> ids = lines.cells[line];
        for (std::size_t i = 1; i < ids.size(); ++i)
            edges.push_back(
                {ids[i - 1], ids[i], radii.at(cell, ids[i - 1]), radii.at(cell, ids[i])});
    }
    VesselTree tree = directed(graph_of_edges(lines.points_mm, edges).graph);
    validate_from_file(tree, path);
    return tree;
}

}  // namespace

void write_tree_vtp(const std::filesystem::path& file, const VesselTree& tree) {
    vtkNew<vtkPolyData> lines;
    const std::vector<Place> places = places_of(tree);
    add_points(tree, places, lines);
    add_segments(tree, places, lines);
    add_field_data(tree, lines);
    write_file_atomically(file, [&](const std::filesystem::path& temporary) {
        vtkNew<vtkXMLPolyDataWriter> writer;
        VtkErrors errors(writer);
        writer->SetFileName(temporary.c_str());
        writer->SetInputData(lines);
        if (writer->Write() == 0 || errors.any() || writer->GetErrorCode() != 0)
            throw InputError("cannot be written", file.string(),
                             "Choose a folder that can be written and has space left");
    });
}

VesselTree read_tree_vtp(const std::filesystem::path& file, const TreeFileFacts& facts) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    if (!std::filesystem::status_known(status))
        refuse(file, "cannot be opened (" + error.message() + ")");
    if (!std::filesystem::exists(status)) refuse(file, "there is no such file");
    Lines lines(file);
    const Vec3 signs = signs_to_lps(space_of(lines, facts, file));
    for (Vec3& point : lines.points_mm) point = signs.cwiseProduct(point);
    const bool own = is_own(lines.file);
    if (own && !facts.in_case) require_known_systems(lines.file, file);
    return own ? own_tree(lines, file) : foreign_tree(lines, facts, file);
}

}  // namespace hepatica
