// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/files/vtk_file.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace hepatica {

namespace {

constexpr std::array array_types{"Int8",  "UInt8",  "Int16",   "UInt16",  "Int32",  "UInt32",
                                 "Int64", "UInt64", "Float32", "Float64", "String", "Bit"};
constexpr std::array formats{"ascii", "binary", "appended"};
constexpr std::array counts{"NumberOfPoints", "NumberOfCells", "NumberOfVerts", "NumberOfLines",
                            "NumberOfStrips", "NumberOfPolys", "NumberOfTuples"};
constexpr long long most_components = 9;  // of a tensor
// Compressed zeros take about a thousandth of their size.
constexpr long long most_items_per_byte = 1100;

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& problem) {
    throw InputError(problem, file.string(), "Save the file anew with the program that wrote it");
}

template <class List>
bool holds(const List& list, const char* text) {
    return text != nullptr && std::ranges::find(list, std::string_view(text)) != list.end();
}

class Check {
  public:
    Check(const std::filesystem::path& file, vtkXMLDataParser* parser)
        : file_(file),
          parser_(parser),
          most_items_(most_items_per_byte *
                      static_cast<long long>(std::filesystem::file_size(file))) {}

    void whole(vtkXMLDataElement* element) const {
        const std::string_view name = element->GetName() != nullptr ? element->GetName() : "";
        for (const char* count : counts) require_number(element, count, 0, most_items_);
        if (name == "DataArray" || name == "Array") array(element);
        if (name == "Points") points(element);
        for (int i = 0; i < element->GetNumberOfNestedElements(); ++i)
            whole(element->GetNestedElement(i));
    }

  private:
    // VTK would write to the terminal.
    void points(vtkXMLDataElement* element) const {
        for (int i = 0; i < element->GetNumberOfNestedElements(); ++i) {
            const char* components =
                element->GetNestedElement(i)->GetAttribute("NumberOfComponents");
            if (components == nullptr || std::string_view(components) != "3")
                refuse(file_, "holds points that are not of three coordinates");
        }
    }

    void array(vtkXMLDataElement* element) const {
        if (!holds(array_types, element->GetAttribute("type")))
            refuse(file_, "holds an array of no known type");
        const char* format = element->GetAttribute("format");
        if (!holds(formats, format)) refuse(file_, "holds an array in no known format");
        // VTK writes beyond texts of several components.
        const bool texts = std::string_view(element->GetAttribute("type")) == "String";
        require_number(element, "NumberOfComponents", 1, texts ? 1 : most_components);
        require_number(element, "offset", 0, most_items_);
        if (texts && std::string_view(format) == "ascii") ascii_texts(element);
    }

    // Each text ends with a 0. VTK writes all of them into as many places as the array says it has.
    void ascii_texts(vtkXMLDataElement* element) const {
        std::vector<unsigned char> bytes(std::filesystem::file_size(file_));
        const std::size_t read = parser_->ReadInlineData(
            element, 1, reinterpret_cast<char*>(bytes.data()), 0, bytes.size(), VTK_UNSIGNED_CHAR);
        bytes.resize(std::min(read, bytes.size()));
        const long long places = number(element, "NumberOfTuples").value_or(places_beside(element));
        if (std::ranges::count(bytes, 0) > places)
            refuse(file_, "holds more texts than it has places for");
    }

    // Of an array of points or cells: as many as the piece has of them.
    static long long places_beside(vtkXMLDataElement* element) {
        vtkXMLDataElement* data = element->GetParent();
        vtkXMLDataElement* piece = data != nullptr ? data->GetParent() : nullptr;
        if (piece == nullptr) return 0;
        if (std::string_view(data->GetName()) == "PointData")
            return number(piece, "NumberOfPoints").value_or(0);
        long long cells = 0;
        for (const char* kind :
             {"NumberOfCells", "NumberOfVerts", "NumberOfLines", "NumberOfStrips", "NumberOfPolys"})
            cells += number(piece, kind).value_or(0);
        return cells;
    }

    static std::optional<long long> number(vtkXMLDataElement* element, const char* attribute) {
        const char* text = element->GetAttribute(attribute);
        if (text == nullptr) return std::nullopt;
        const std::string_view digits(text);
        long long value = 0;
        const auto [end, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
        return value;
    }

    // Where the element has the attribute.
    void require_number(vtkXMLDataElement* element, const char* attribute, long long least,
                        long long most) const {
        const char* text = element->GetAttribute(attribute);
        if (text == nullptr) return;
        const std::optional<long long> value = number(element, attribute);
        if (!value || *value < least || *value > most)
            refuse(file_, std::string("has a ") + attribute + " of \"" + text + "\"");
    }

    const std::filesystem::path& file_;
    vtkXMLDataParser* parser_;
    long long most_items_;
};

}  // namespace

void check_vtk_xml(const std::filesystem::path& file) {
    vtkNew<vtkXMLDataParser> parser;
    bool failed = false;
    vtkNew<vtkCallbackCommand> on_error;  // with an observer VTK does not write to the terminal
    on_error->SetClientData(&failed);
    on_error->SetCallback(
        [](vtkObject*, unsigned long, void* flag, void*) { *static_cast<bool*>(flag) = true; });
    parser->AddObserver(vtkCommand::ErrorEvent, on_error);
    std::ifstream in(file, std::ios::binary);  // stays open: texts are read through it
    parser->SetStream(&in);
    if (parser->Parse() == 0 || failed || parser->GetRootElement() == nullptr)
        refuse(file, "is damaged, or no XML file of VTK");
    Check(file, parser).whole(parser->GetRootElement());
}

void check_vtk_cells(vtkCellArray* cells, long long points, const std::filesystem::path& file) {
    const auto offset = [cells](vtkIdType cell) {
        return static_cast<vtkIdType>(cells->GetOffsetsArray()->GetComponent(cell, 0));
    };
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell) {
        const vtkIdType begin = offset(cell), end = offset(cell + 1);
        if (begin < 0 || end < begin || end > cells->GetNumberOfConnectivityIds())
            refuse(file, "the offsets of its cells do not fit their connectivity");
        cells->GetCellAtId(cell, ids);
        for (const vtkIdType id : *ids)
            if (id < 0 || id >= points)
                refuse(file, "a cell names point " + std::to_string(id) + " of " +
                                 std::to_string(points));
    }
}

}  // namespace hepatica
