// SPDX-License-Identifier: GPL-3.0-or-later
// Parses the XML with VTK's parser, and decodes data arrays with checked sizes.
#include "core/tree/files/vtk_document.h"

#include <vtkObjectFactory.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "core/base/error.h"
#include "core/base/text_file.h"
#include "core/tree/files/vtk_errors.h"

namespace hepatica {

// VTK's parser with a limit on nesting, because VTK destroys elements recursively.
class VtkXmlParser : public vtkXMLDataParser {
  public:
    static VtkXmlParser* New();
    vtkTypeMacro(VtkXmlParser, vtkXMLDataParser) VtkXmlParser(const VtkXmlParser&) = delete;
    VtkXmlParser& operator=(const VtkXmlParser&) = delete;

    bool too_deep() const { return too_deep_; }

  protected:
    VtkXmlParser() { IgnoreCharacterData = 1; }
    void StartElement(const char* name, const char** attributes) override {
        if (++depth_ <= most_depth)
            vtkXMLDataParser::StartElement(name, attributes);
        else
            too_deep_ = true;
    }
    void EndElement(const char* name) override {
        if (depth_-- <= most_depth) vtkXMLDataParser::EndElement(name);
    }

  private:
    static constexpr int most_depth = 32;
    int depth_ = 0;
    bool too_deep_ = false;
};

vtkStandardNewMacro(VtkXmlParser);

namespace {

constexpr std::string_view spaces = " \t\r\n";
constexpr std::size_t most_components = 9;

// A numeric type of a file: its name, its size, and its value from text or from bytes in native
// order.
struct NumberType {
    std::string_view name;
    std::size_t bytes;
    std::optional<double> (*from_text)(std::string_view);
    double (*from_bytes)(const char*);
};

template <class T>
constexpr NumberType number_type(std::string_view name) {
    return {name, sizeof(T),
            [](std::string_view text) -> std::optional<double> {
                // Whole numbers may be written with a point, too.
                double value = 0.0;
                const auto [end, error] =
                    std::from_chars(text.data(), text.data() + text.size(), value);
                if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
                if constexpr (std::is_same_v<T, float>) return static_cast<float>(value);
                return value;
            },
            [](const char* bytes) {
                T value;
                std::memcpy(&value, bytes, sizeof(T));
                return static_cast<double>(value);
            }};
}

constexpr std::array number_types{
    number_type<std::int8_t>("Int8"),   number_type<std::uint8_t>("UInt8"),
    number_type<std::int16_t>("Int16"), number_type<std::uint16_t>("UInt16"),
    number_type<std::int32_t>("Int32"), number_type<std::uint32_t>("UInt32"),
    number_type<std::int64_t>("Int64"), number_type<std::uint64_t>("UInt64"),
    number_type<float>("Float32"),      number_type<double>("Float64")};

std::string attribute(vtkXMLDataElement* element, const char* name) {
    const char* text = element->GetAttribute(name);
    return text != nullptr ? text : "";
}

std::vector<double> from_text(std::string_view text, const NumberType& type) {
    std::vector<double> values;
    for (std::size_t begin = text.find_first_not_of(spaces); begin != std::string_view::npos;) {
        const std::string_view word = text.substr(begin, text.find_first_of(spaces, begin) - begin);
        const std::optional<double> value = type.from_text(word);
        if (!value)
            throw std::invalid_argument("has \"" + std::string(word.substr(0, 40)) +
                                        "\" in place of a number");
        values.push_back(*value);
        begin = text.find_first_not_of(spaces, begin + word.size());
    }
    return values;
}

std::vector<double> from_bytes(std::string bytes, const NumberType& type, bool swapped) {
    if (bytes.size() % type.bytes != 0)
        throw std::invalid_argument("has " + std::to_string(bytes.size()) +
                                    " bytes, no whole number of values");
    std::vector<double> values(bytes.size() / type.bytes);
    for (std::size_t i = 0; i < values.size(); ++i) {
        char* first = bytes.data() + i * type.bytes;
        if (swapped) std::reverse(first, first + type.bytes);
        values[i] = type.from_bytes(first);
    }
    return values;
}

VtkEncoding encoding_of(const VtkDocument& document, vtkXMLDataElement* root) {
    VtkEncoding encoding;
    encoding.big_endian = attribute(root, "byte_order") == "BigEndian";
    encoding.header_bytes = attribute(root, "header_type") == "UInt64" ? 8 : 4;
    const std::string compressor = attribute(root, "compressor");
    if (compressor == "vtkZLibDataCompressor")
        encoding.compressor = VtkCompressor::zlib;
    else if (compressor == "vtkLZ4DataCompressor")
        encoding.compressor = VtkCompressor::lz4;
    else if (!compressor.empty())
        document.refuse("is compressed by \"" + compressor + "\", neither zlib nor LZ4");
    return encoding;
}

}  // namespace

VtkDocument::VtkDocument(const std::filesystem::path& file)
    : file_(file),
      bytes_(read_text_file(file, "Give a file of VTK's XML formats")),
      parser_(VtkXmlParser::New()) {
    VtkErrors errors(parser_.get());
    std::ifstream in(file, std::ios::binary);
    parser_->SetStream(&in);
    const bool parsed = parser_->Parse() != 0 && !errors.any() && !parser_->too_deep();
    parser_->SetStream(nullptr);
    if (!parsed || root() == nullptr) refuse("is damaged, or no XML file of VTK");
    encoding_ = encoding_of(*this, root());
}

VtkDocument::~VtkDocument() = default;

void VtkDocument::Release::operator()(VtkXmlParser* parser) const {
    parser->Delete();
}

vtkXMLDataElement* VtkDocument::root() const {
    return parser_->GetRootElement();
}

std::size_t VtkDocument::number(vtkXMLDataElement* element, const char* name,
                                std::size_t otherwise) const {
    const char* text = element->GetAttribute(name);
    if (text == nullptr) return otherwise;
    const char* text_end = text + std::strlen(text);
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text, text_end, value);
    // Deflate compresses zeros to about a thousandth; larger counts cannot be valid.
    constexpr std::size_t most_items_per_byte = 1100;
    if (error != std::errc{} || end != text_end || value / most_items_per_byte > bytes_.size())
        refuse(std::string("has a ") + name + " of \"" + text + "\"");
    return value;
}

std::size_t VtkDocument::components(vtkXMLDataElement* array) const {
    const std::size_t components = number(array, "NumberOfComponents", 1);
    if (components == 0 || components > most_components)
        refuse(array, "has a NumberOfComponents of \"" + std::to_string(components) + "\"");
    return components;
}

std::vector<double> VtkDocument::numbers(vtkXMLDataElement* array,
                                         std::optional<std::size_t> count) const {
    const auto* type = std::ranges::find(number_types, attribute(array, "type"), &NumberType::name);
    if (type == number_types.end()) refuse(array, "is of no known type");
    std::vector<double> values;
    try {
        if (is_text(array)) {
            values = from_text(inline_text(array), *type);
        } else {
            const bool swapped = encoding_.big_endian != (std::endian::native == std::endian::big);
            values = from_bytes(
                payload(array, count ? std::optional(*count * type->bytes) : std::nullopt), *type,
                swapped);
        }
    } catch (const std::invalid_argument& error) {
        refuse(array, error.what());
    }
    if (count && values.size() != *count)
        refuse(array, "has " + std::to_string(values.size()) + " numbers instead of " +
                          std::to_string(*count));
    return values;
}

std::vector<std::string> VtkDocument::texts(vtkXMLDataElement* array, std::size_t count) const {
    if (attribute(array, "type") != "String") refuse(array, "is of no known type");
    if (components(array) != 1)
        refuse(array, "holds texts with a NumberOfComponents of \"" +
                          attribute(array, "NumberOfComponents") + "\"");
    std::string all;
    try {
        if (is_text(array))
            for (const double character : from_text(inline_text(array), number_types[1])) {
                if (!(character >= -128.0 && character < 256.0))
                    refuse(array, "has the character " + std::to_string(character));
                all += static_cast<char>(static_cast<int>(character));
            }
        else
            all = payload(array, std::nullopt);
    } catch (const std::invalid_argument& error) {
        refuse(array, error.what());
    }
    std::vector<std::string> texts;
    for (std::size_t begin = 0; begin < all.size();) {
        const std::size_t end = std::min(all.find('\0', begin), all.size());
        texts.push_back(all.substr(begin, end - begin));
        begin = end + 1;
    }
    if (texts.size() != count)
        refuse(array, "has " + std::to_string(texts.size()) + " texts instead of " +
                          std::to_string(count));
    return texts;
}

bool VtkDocument::is_text(vtkXMLDataElement* array) const {
    const std::string format = attribute(array, "format");
    if (format != "ascii" && format != "binary" && format != "appended")
        refuse(array, "is in no known format");
    return format == "ascii";
}

// The text between the element's tags.
std::string_view VtkDocument::inline_text(vtkXMLDataElement* array) const {
    const std::string_view all = bytes_;
    auto at = static_cast<std::size_t>(array->GetXMLByteIndex());
    char quote = '\0';
    for (; at < all.size() && (quote != '\0' || all[at] != '>'); ++at) {
        if (quote == '\0' && (all[at] == '"' || all[at] == '\''))
            quote = all[at];
        else if (all[at] == quote)
            quote = '\0';
    }
    if (at >= all.size() || all[at - 1] == '/') return {};
    std::string_view text = all.substr(at + 1);
    text = text.substr(0, text.find('<'));
    const std::size_t first = std::min(text.find_first_not_of(spaces), text.size());
    text.remove_prefix(first);
    return text.substr(0, text.find_last_not_of(spaces) + 1);
}

std::string VtkDocument::payload(vtkXMLDataElement* array, std::optional<std::size_t> bytes) const {
    VtkEncoding encoding = encoding_;
    if (attribute(array, "format") == "binary") {
        encoding.base64 = true;
        return vtk_payload(inline_text(array), encoding, bytes);
    }
    vtkXMLDataElement* appended = root()->FindNestedElementWithName("AppendedData");
    const std::size_t begin = static_cast<std::size_t>(parser_->GetAppendedDataPosition());
    const std::size_t offset = number(array, "offset", 0);
    if (appended == nullptr || begin > bytes_.size() || offset > bytes_.size() - begin)
        refuse(array, "has an offset of \"" + std::to_string(offset) + "\" beyond the file's data");
    encoding.base64 = attribute(appended, "encoding") == "base64";
    return vtk_payload(std::string_view(bytes_).substr(begin + offset), encoding, bytes);
}

void VtkDocument::refuse(const std::string& problem) const {
    throw InputError(problem, file_.string(), "Save the file anew with the program that wrote it");
}

void VtkDocument::refuse(vtkXMLDataElement* array, const std::string& problem) const {
    refuse("its array \"" + attribute(array, "Name") + "\" " + problem);
}

}  // namespace hepatica
