// SPDX-License-Identifier: GPL-3.0-or-later
// The elements and arrays of a file of VTK's XML formats, before anybody knows what they mean.
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

// The functions throw InputError that names the file and the value that is wrong.
class VtkDocument {
  public:
    explicit VtkDocument(const std::filesystem::path& file);
    ~VtkDocument();
    VtkDocument(const VtkDocument&) = delete;
    VtkDocument& operator=(const VtkDocument&) = delete;

    vtkXMLDataElement* root() const;

    // A whole number from 0; `otherwise` where the element has no such attribute.
    std::size_t number(vtkXMLDataElement* element, const char* attribute,
                       std::size_t otherwise) const;
    // 1 to 9, as of a tensor.
    std::size_t components(vtkXMLDataElement* array) const;

    // The values of an array of numbers, one after the other; `count`: how many there must be.
    std::vector<double> numbers(vtkXMLDataElement* array, std::optional<std::size_t> count) const;
    // The texts of an array, each of which ends with a 0.
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
    VtkEncoding encoding_;  // but for base64, which each array says
};

}  // namespace hepatica
