// SPDX-License-Identifier: GPL-3.0-or-later
// The XML elements and data arrays of a file in VTK's XML formats, without their meaning.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/tree/files/vtk_payload.h"

class vtkXMLDataElement;

namespace hepatica {

class VtkXmlParser;

// The functions throw InputError that names the file and the wrong value. Not thread-safe.
class VtkDocument {
  public:
    explicit VtkDocument(const std::filesystem::path& file);
    ~VtkDocument();
    VtkDocument(const VtkDocument&) = delete;
    VtkDocument& operator=(const VtkDocument&) = delete;

    vtkXMLDataElement* root() const;

    // A whole number from 0 on; `otherwise` where the attribute is missing.
    std::size_t number(vtkXMLDataElement* element, const char* attribute,
                       std::size_t otherwise) const;
    // NumberOfComponents, 1 to 9.
    std::size_t components(vtkXMLDataElement* array) const;

    // All values of a numeric array; `count`: required number of values, if known.
    std::vector<double> numbers(vtkXMLDataElement* array, std::optional<std::size_t> count) const;
    // The zero-terminated texts of an array.
    std::vector<std::string> texts(vtkXMLDataElement* array, std::size_t count) const;

    [[noreturn]] void refuse(const std::string& problem) const;
    [[noreturn]] void refuse(vtkXMLDataElement* array, const std::string& problem) const;

  private:
    struct Release {
        void operator()(VtkXmlParser* parser) const;
    };

    std::string_view inline_text(vtkXMLDataElement* array) const;
    std::string payload(vtkXMLDataElement* array, std::optional<std::size_t> bytes) const;
    bool is_text(vtkXMLDataElement* array) const;

    std::filesystem::path file_;
    std::string bytes_;  // of the whole file
    std::unique_ptr<VtkXmlParser, Release> parser_;
    VtkEncoding encoding_;  // except base64, which each array states
};

}  // namespace hepatica
