// SPDX-License-Identifier: GPL-3.0-or-later
// Finds points, cells and arrays in a VTK document and checks their indices.
#include "core/tree/files/vtk_file.h"

#include <vtkXMLDataElement.h>

#include <array>
#include <cmath>
#include <limits>

namespace hepatica {

namespace {

constexpr std::array cell_kinds{"Verts", "Lines", "Strips", "Polys", "Cells"};

std::string_view text_of(const char* attribute) {
    return attribute != nullptr ? attribute : "";
}

bool is_array(vtkXMLDataElement* element) {
    const std::string_view name = text_of(element->GetName());
    return name == "DataArray" || name == "Array";
}

bool holds_texts(vtkXMLDataElement* array) {
    return text_of(array->GetAttribute("type")) == "String";
}

vtkXMLDataElement* array_of(vtkXMLDataElement* parent, std::string_view name) {
    for (int i = 0; parent != nullptr && i < parent->GetNumberOfNestedElements(); ++i) {
        vtkXMLDataElement* element = parent->GetNestedElement(i);
        if (is_array(element) && text_of(element->GetAttribute("Name")) == name) return element;
    }
    return nullptr;
}

// The value as a whole number from 0 to `most`; none where it is not one.
std::optional<std::size_t> whole_number(double value, std::size_t most) {
    if (!(value >= 0.0 && value <= static_cast<double>(most)) || value != std::floor(value))
        return std::nullopt;
    return static_cast<std::size_t>(value);
}

}  // namespace

VtkFile::VtkFile(const std::filesystem::path& file, std::string_view type) : document_(file) {
    vtkXMLDataElement* root = document_.root();
    if (text_of(root->GetAttribute("type")) != type)
        document_.refuse("is of type \"" + std::string(text_of(root->GetAttribute("type"))) +
                         "\" instead of " + std::string(type));
    whole_ = root->FindNestedElementWithName(std::string(type).c_str());
    if (whole_ == nullptr) document_.refuse("holds no " + std::string(type));
    for (int i = 0; i < whole_->GetNumberOfNestedElements(); ++i) {
        vtkXMLDataElement* element = whole_->GetNestedElement(i);
        if (text_of(element->GetName()) != "Piece") continue;
        if (document_.number(element, "NumberOfPoints", 0) == 0) continue;
        if (piece_ != nullptr) document_.refuse("holds several pieces, of which one can be read");
        piece_ = element;
    }
    if (piece_ == nullptr) document_.refuse("holds no points");
}

std::size_t VtkFile::point_count() const {
    const std::size_t count = document_.number(piece_, "NumberOfPoints", 0);
    if (count > std::numeric_limits<int>::max())
        document_.refuse("has a NumberOfPoints of \"" + std::to_string(count) + "\"");
    return count;
}

std::vector<Vec3> VtkFile::points() const {
    vtkXMLDataElement* element = piece_->FindNestedElementWithName("Points");
    vtkXMLDataElement* array = nullptr;
    for (int i = 0; element != nullptr && i < element->GetNumberOfNestedElements(); ++i)
        if (array == nullptr && is_array(element->GetNestedElement(i)))
            array = element->GetNestedElement(i);
    if (array == nullptr || document_.components(array) != 3)
        document_.refuse("holds points that are not of three coordinates");
    const std::vector<double> values = document_.numbers(array, 3 * point_count());
    std::vector<Vec3> points(point_count());
    for (std::size_t p = 0; p < points.size(); ++p)
        points[p] = Vec3(values[3 * p], values[3 * p + 1], values[3 * p + 2]);
    return points;
}

std::size_t VtkFile::cell_count(const char* kind) const {
    return document_.number(piece_, (std::string("NumberOf") + kind).c_str(), 0);
}

VtkCells VtkFile::cells(const char* kind) const {
    VtkCells cells;
    const std::size_t count = cell_count(kind);
    if (count == 0) return cells;
    vtkXMLDataElement* element = piece_->FindNestedElementWithName(kind);
    vtkXMLDataElement* offsets = array_of(element, "offsets");
    vtkXMLDataElement* connectivity = array_of(element, "connectivity");
    if (offsets == nullptr || connectivity == nullptr)
        document_.refuse(std::string("does not say which points its ") + kind + " have");
    const std::vector<double> names = document_.numbers(connectivity, std::nullopt);
    for (const double end : document_.numbers(offsets, count)) {
        const std::optional<std::size_t> whole = whole_number(end, names.size());
        if (!whole || (!cells.ends.empty() && *whole < cells.ends.back()))
            document_.refuse(offsets, "does not fit the connectivity of " +
                                          std::to_string(names.size()) + " points");
        cells.ends.push_back(*whole);
    }
    for (const double name : names) {
        const std::optional<std::size_t> point = whole_number(name, point_count() - 1);
        if (!point)
            document_.refuse("a cell names point " + std::to_string(std::llround(name)) + " of " +
                             std::to_string(point_count()));
        cells.points.push_back(static_cast<int>(*point));
    }
    return cells;
}

std::vector<double> VtkFile::cell_types() const {
    vtkXMLDataElement* types = array_of(piece_->FindNestedElementWithName("Cells"), "types");
    if (types == nullptr) document_.refuse("does not say of what kind its cells are");
    return document_.numbers(types, cell_count("Cells"));
}

std::vector<std::string> VtkFile::names_of_numbers(const char* data) const {
    std::vector<std::string> names;
    vtkXMLDataElement* element = part(data);
    for (int i = 0; element != nullptr && i < element->GetNumberOfNestedElements(); ++i) {
        vtkXMLDataElement* array = element->GetNestedElement(i);
        const std::string_view name = text_of(array->GetAttribute("Name"));
        // Of several arrays of one name numbers() finds the first, which may be of texts.
        if (is_array(array) && !holds_texts(array) && document_.components(array) == 1 &&
            array_of(element, name) == array)
            names.emplace_back(name);
    }
    return names;
}

bool VtkFile::has(const char* data, std::string_view name) const {
    return array(data, name) != nullptr;
}

std::optional<std::vector<double>> VtkFile::numbers(const char* data, std::string_view name) const {
    vtkXMLDataElement* found = array(data, name);
    if (found == nullptr || holds_texts(found) || document_.components(found) != 1)
        return std::nullopt;
    return document_.numbers(found, tuples(data, found));
}

std::optional<std::vector<std::string>> VtkFile::texts(const char* data,
                                                       std::string_view name) const {
    vtkXMLDataElement* found = array(data, name);
    if (found == nullptr || text_of(found->GetName()) != "Array") return std::nullopt;
    return document_.texts(found, tuples(data, found).value_or(1));
}

vtkXMLDataElement* VtkFile::part(const char* data) const {
    const bool of_all = text_of(data) == "FieldData";
    return (of_all ? whole_ : piece_)->FindNestedElementWithName(data);
}

vtkXMLDataElement* VtkFile::array(const char* data, std::string_view name) const {
    return array_of(part(data), name);
}

std::optional<std::size_t> VtkFile::tuples(const char* data, vtkXMLDataElement* array) const {
    if (text_of(data) == "PointData") return point_count();
    std::size_t cells = 0;
    for (const char* kind : cell_kinds) cells += cell_count(kind);
    if (text_of(data) == "CellData") return cells;
    if (array->GetAttribute("NumberOfTuples") == nullptr) return std::nullopt;
    return document_.number(array, "NumberOfTuples", 0);
}

}  // namespace hepatica
