// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/files/tree_io.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <cctype>
#include <numbers>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/base/patient_space.h"
#include "core/tree/extraction/line_graph.h"
#include "core/tree/files/tree_files.h"
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

// Where each segment stands in its tree.
struct Place {
    int tree = 0;           // number of its tree, by root
    int depth = 0;          // bifurcations between its tree's root and its beginning
    double start_mm = 0.0;  // way from its tree's root to its beginning
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

vtkSmartPointer<vtkPolyData> read_lines(const std::filesystem::path& file) {
    if (!std::filesystem::is_regular_file(file)) refuse(file, "there is no such file");
    vtkNew<vtkXMLPolyDataReader> reader;
    // With an observer VTK reports here instead of writing to the terminal.
    bool failed = false;
    vtkNew<vtkCallbackCommand> on_error;
    on_error->SetClientData(&failed);
    on_error->SetCallback(
        [](vtkObject*, unsigned long, void* flag, void*) { *static_cast<bool*>(flag) = true; });
    reader->AddObserver(vtkCommand::ErrorEvent, on_error);
    reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, on_error);
    reader->SetParserErrorObserver(on_error);
    reader->SetReaderErrorObserver(on_error);
    reader->SetFileName(file.c_str());
    check_vtk_xml(file);
    if (reader->CanReadFile(file.c_str()) == 0) refuse(file, "is not a VTK polygon file (VTP)");
    reader->Update();
    vtkSmartPointer<vtkPolyData> lines = reader->GetOutput();
    if (failed || lines == nullptr || reader->GetErrorCode() != 0) refuse(file, "is damaged");
    if (lines->GetNumberOfLines() == 0) refuse(file, "holds no lines");
    check_vtk_cells(lines->GetLines(), lines->GetNumberOfPoints(), file);
    return lines;
}

// What the field data SPACE say: "LPS", "RAS", or 3D Slicer's "SPACE=RAS"; "" where they are
// missing.
std::string stated_space(vtkPolyData* lines) {
    const auto* space =
        vtkStringArray::SafeDownCast(lines->GetFieldData()->GetAbstractArray("SPACE"));
    if (space == nullptr || space->GetNumberOfValues() == 0) return "";
    const std::string text = space->GetValue(0);
    return text.starts_with("SPACE=") ? text.substr(6) : text;
}

PatientSpace space_of(vtkPolyData* lines, const TreeFileFacts& facts,
                      const std::filesystem::path& file) {
    const std::string stated = stated_space(lines);
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

Vec3 point_at(vtkPolyData* lines, vtkIdType id, const Vec3& signs) {
    Vec3 p;
    lines->GetPoint(id, p.data());
    return signs.cwiseProduct(p);
}

template <class Visit>
void for_each_line(vtkPolyData* lines, const Visit& visit) {
    auto cells = vtk::TakeSmartPointer(lines->GetLines()->NewIterator());
    // Cell data numbers vertices before lines.
    vtkIdType cell = lines->GetNumberOfVerts();
    for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell(), ++cell) {
        vtkIdType count = 0;
        const vtkIdType* ids = nullptr;
        cells->GetCurrentCell(count, ids);
        visit(cell, std::vector<vtkIdType>(ids, ids + count));
    }
}

bool is_own(vtkPolyData* lines) {
    for (const char* name : {"SegmentId", "ParentId", "System", "StrahlerOrder", "ClosesLoop",
                             "ProximalNode", "DistalNode"})
        if (vtkDataArray* array = lines->GetCellData()->GetArray(name);
            array == nullptr || array->GetNumberOfComponents() != 1)
            return false;
    return lines->GetFieldData()->GetArray("NodeRadius") != nullptr &&
           lines->GetPointData()->GetArray("Radius") != nullptr;
}

void require_known_systems(vtkPolyData* lines, const std::filesystem::path& file) {
    if (lines->GetCellData()->GetAbstractArray("SystemName") != nullptr) return;
    vtkDataArray* system = lines->GetCellData()->GetArray("System");
    std::vector<int> numbers;
    for (vtkIdType cell = 0; cell < system->GetNumberOfTuples(); ++cell)
        numbers.push_back(static_cast<int>(system->GetComponent(cell, 0)));
    require_unambiguous_systems(numbers, file);
}

VesselTree own_tree(vtkPolyData* lines, const Vec3& signs, const std::filesystem::path& file) {
    VesselTree tree;
    vtkDataArray* node_radii = lines->GetFieldData()->GetArray("NodeRadius");
    vtkDataArray* radii = lines->GetPointData()->GetArray("Radius");
    vtkDataArray* bridged = lines->GetPointData()->GetArray("Bridged");       // may be missing
    vtkDataArray* confidence = lines->GetCellData()->GetArray("Confidence");  // may be missing
    tree.nodes.resize(node_radii->GetNumberOfTuples());
    for (std::size_t n = 0; n < tree.nodes.size(); ++n)
        tree.nodes[n].radius_mm = node_radii->GetComponent(static_cast<vtkIdType>(n), 0);
    for_each_line(lines, [&](vtkIdType cell, const std::vector<vtkIdType>& ids) {
        const auto value = [&](const char* name) {
            return static_cast<int>(lines->GetCellData()->GetArray(name)->GetComponent(cell, 0));
        };
        if (value("SegmentId") != static_cast<int>(tree.segments.size()))
            refuse(file, "its segments are not in the order of SegmentId");
        VesselSegment segment;
        segment.parent = value("ParentId");
        segment.system = system_numbered(value("System")).value_or(VascularSystem::unknown);
        if (confidence != nullptr) segment.system_confidence = confidence->GetComponent(cell, 0);
        segment.strahler_order = value("StrahlerOrder");
        segment.closes_loop = value("ClosesLoop") != 0;
        segment.proximal_node = value("ProximalNode");
        segment.distal_node = value("DistalNode");
        for (const vtkIdType id : ids) {
            segment.points_mm.push_back(point_at(lines, id, signs));
            segment.radii_mm.push_back(radii->GetComponent(id, 0));
            segment.bridged.push_back(bridged && bridged->GetComponent(id, 0) != 0.0 ? 1 : 0);
        }
        if (std::ranges::count(segment.bridged, 1) == 0) segment.bridged.clear();
        tree.segments.push_back(std::move(segment));
    });
    validate_from_file(tree, file);  // the node numbers are used below
    for (const VesselSegment& segment : tree.segments) {
        tree.nodes[segment.proximal_node].position_mm = segment.points_mm.front();
        tree.nodes[segment.distal_node].position_mm = segment.points_mm.back();
    }
    return tree;
}

vtkDataArray* radius_array(vtkFieldData* data) {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
        vtkDataArray* array = data->GetArray(i);
        if (array == nullptr || array->GetName() == nullptr || array->GetNumberOfComponents() != 1)
            continue;
        std::string name = array->GetName();
        std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
        if (name.find("radius") != std::string::npos) return array;
    }
    return nullptr;
}

// The radius at a point of a line: from the first array that speaks of one, or as stated.
class Radii {
  public:
    Radii(vtkPolyData* lines, const TreeFileFacts& facts, const std::filesystem::path& file)
        : at_points_(radius_array(lines->GetPointData())),
          at_cells_(radius_array(lines->GetCellData())),
          stated_mm_(facts.radius_mm) {
        const bool in_file = at_points_ != nullptr || at_cells_ != nullptr;
        if (!in_file && !stated_mm_)
            throw InputError(
                "holds no radii", file.string(),
                "Give the lines a point or cell array MaximumInscribedSphereRadius or Radius [mm], "
                "or state one radius for all vessels: --radius-mm");
        if (in_file && stated_mm_)
            throw InputError("holds radii of its own", file.string(), "Leave --radius-mm out");
    }
    double at(vtkIdType cell, vtkIdType point) const {
        if (at_points_ != nullptr) return at_points_->GetComponent(point, 0);
        return at_cells_ != nullptr ? at_cells_->GetComponent(cell, 0) : *stated_mm_;
    }

  private:
    vtkDataArray* at_points_;
    vtkDataArray* at_cells_;
    std::optional<double> stated_mm_;
};

VesselTree foreign_tree(vtkPolyData* lines, const Vec3& signs, const TreeFileFacts& facts,
                        const std::filesystem::path& file) {
    std::vector<Vec3> points(lines->GetNumberOfPoints());
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i] = point_at(lines, static_cast<vtkIdType>(i), signs);
        require_in_patient_space(points[i], "a point", file.string());
    }
    const Radii radii(lines, facts, file);
    std::vector<LineEdge> edges;
    for_each_line(lines, [&](vtkIdType cell, const std::vector<vtkIdType>& ids) {
        for (std::size_t i = 1; i < ids.size(); ++i)
            edges.push_back({static_cast<int>(ids[i - 1]), static_cast<int>(ids[i]),
                             radii.at(cell, ids[i - 1]), radii.at(cell, ids[i])});
    });
    return directed(graph_of_edges(points, edges).graph);
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
        writer->SetFileName(temporary.c_str());
        writer->SetInputData(lines);
        if (writer->Write() == 0 || writer->GetErrorCode() != 0)
            throw InputError("cannot be written", file.string(),
                             "Choose a folder that can be written and has space left");
    });
}

VesselTree read_tree_vtp(const std::filesystem::path& file, const TreeFileFacts& facts) {
    const vtkSmartPointer<vtkPolyData> lines = read_lines(file);
    const Vec3 signs = signs_to_lps(space_of(lines, facts, file));
    const bool own = is_own(lines);
    if (own && !facts.in_case) require_known_systems(lines, file);
    VesselTree tree = own ? own_tree(lines, signs, file) : foreign_tree(lines, signs, facts, file);
    validate_from_file(tree, file);
    return tree;
}

}  // namespace hepatica
