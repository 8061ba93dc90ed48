// SPDX-License-Identifier: GPL-3.0-or-later
// A parser for explicit and implicit VR, both byte orders, nested sequences, fragments and deflated
// data sets.
#include "core/image/dicom_header.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>

#include "core/base/error.h"
#include "core/image/byte_stream.h"
#include "core/image/header_text.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

constexpr std::uint32_t undefined_length = 0xffffffff;
constexpr std::uint32_t longest_value = 4096;
constexpr int deepest_nesting = 32;

constexpr std::uint32_t pixel_data = 0x7fe00010;
constexpr std::uint32_t transfer_syntax_uid = 0x00020010;
constexpr std::uint32_t modality_lut = 0x00283000;
constexpr std::uint32_t contrast_agents = 0x00180012;
// Functional groups (PS3.3 C.7.6.16), the sequences within them that are parsed, and the values
// that are kept from those.
constexpr std::array<std::uint32_t, 2> functional_groups{0x52009229, 0x52009230};
constexpr std::array<std::uint32_t, 4> described_in{0x00209113, 0x00209116, 0x00289110, 0x00189314};
constexpr std::array<std::uint32_t, 4> group_values_kept{0x00200032, 0x00200037, 0x00280030,
                                                         0x00181210};
constexpr std::size_t most_group_values = 100'000;  // per tag; no scan has that many frames
constexpr std::uint32_t item = 0xfffee000;
constexpr std::uint32_t item_end = 0xfffee00d;
constexpr std::uint32_t sequence_end = 0xfffee0dd;

// Thrown where the bytes contradict the format.
struct Damaged {};

struct DataEncoding {
    bool explicit_vr = true;
    bool big_endian = false;
};

struct ElementHead {
    std::uint32_t tag = 0;
    std::array<char, 2> vr{' ', ' '};
    std::uint32_t length = 0;
};

// The encoding of what lies within an element. A sequence with VR UN is encoded without value
// representations (PS3.5 6.2.2).
DataEncoding encoding_within(const ElementHead& head, const DataEncoding& around) {
    return {around.explicit_vr && head.vr[0] != 'U', around.big_endian};
}

constexpr const char* deflated_syntax = "1.2.840.10008.1.2.1.99";

class Parser {
  public:
    Parser(std::istream& in, std::uint64_t size) : in_(in), size_(size) {}

    // Parses the file meta group, and the rest unless it is deflated.
    DicomHeader parse() {
        DicomHeader header;
        const DataEncoding encoding = begin(header);
        if (header.transfer_syntax == deflated_syntax)
            header.deflated_at = position_;
        else
            parse_data(encoding, header);
        return header;
    }

    void parse_data(const DataEncoding& encoding, DicomHeader& header) {
        header.big_endian = encoding.big_endian;
        while (position_ < size_) {
            const ElementHead head = read_head(encoding);
            if (head.tag == pixel_data) {
                find_pixels(head, header);
                break;
            }
            take(head, encoding, header);
        }
    }

  private:
    void read(void* buffer, std::size_t bytes) {
        if (bytes > size_ - position_ ||
            !in_.read(static_cast<char*>(buffer), static_cast<std::streamsize>(bytes)))
            throw Damaged();
        position_ += bytes;
    }
    void skip(std::uint64_t bytes) {
        if (bytes > size_ - position_) throw Damaged();
        position_ += bytes;
        in_.seekg(static_cast<std::streamoff>(position_));
    }
    void go_to(std::uint64_t position) {
        position_ = position;
        in_.clear();
        in_.seekg(static_cast<std::streamoff>(position_));
    }
    std::uint32_t word(std::size_t bytes, bool big_endian) {
        std::array<unsigned char, 4> raw{};
        read(raw.data(), bytes);
        if (big_endian) std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(bytes));
        return raw[0] | raw[1] << 8 | raw[2] << 16 | static_cast<std::uint32_t>(raw[3]) << 24;
    }

    ElementHead read_head(const DataEncoding& encoding) {
        ElementHead head;
        const std::uint32_t group = word(2, encoding.big_endian);
        head.tag = group << 16 | word(2, encoding.big_endian);
        if (!encoding.explicit_vr || group == 0xfffe) {
            head.length = word(4, encoding.big_endian);
            return head;
        }
        read(head.vr.data(), 2);
        static constexpr std::array<std::string_view, 13> long_forms{
            "OB", "OD", "OF", "OL", "OV", "OW", "SQ", "SV", "UC", "UN", "UR", "UT", "UV"};
        const std::string_view vr(head.vr.data(), 2);
        if (std::ranges::find(long_forms, vr) != long_forms.end()) {
            skip(2);
            head.length = word(4, encoding.big_endian);
        } else {
            head.length = word(2, encoding.big_endian);
        }
        return head;
    }

    // Keeps short values and skips the rest.
    void take(const ElementHead& head, const DataEncoding& encoding, DicomHeader& header) {
        const DataEncoding within = encoding_within(head, encoding);
        if (std::ranges::count(functional_groups, head.tag) > 0) {
            return look_into(head.length, within, 0, header);
        }
        bool empty = head.length == 0;
        if (head.length == undefined_length) {
            empty = skip_sequence(within, 0) == 0;
        } else if (head.length > longest_value || head.vr == std::array<char, 2>{'S', 'Q'}) {
            skip(head.length);
        } else {
            std::string value(head.length, '\0');
            read(value.data(), value.size());
            header.values[head.tag] = std::move(value);
        }
        if (head.tag == modality_lut && !empty) header.has_modality_lut = true;
        if (head.tag == contrast_agents && !empty) header.has_contrast_agents = true;
    }

    // Where an element that begins here with this length ends; the end of the file if the length is
    // undefined.
    std::uint64_t end_of(std::uint32_t length) const {
        if (length == undefined_length) return size_;
        if (length > size_ - position_) throw Damaged();
        return position_ + length;
    }

    // Calls `each` for the head of every element of a sequence or an item, up to its end. `last` is
    // the tag that ends one of undefined length.
    template <typename Each>
    void for_each(std::uint32_t length, std::uint32_t last, const DataEncoding& encoding,
                  const Each& each) {
        const std::uint64_t end = end_of(length);
        while (length == undefined_length || position_ < end) {
            const ElementHead head = read_head(encoding);
            if (head.tag == last && length == undefined_length) return;
            each(head);
            if (position_ > end) throw Damaged();
        }
    }

    // Parses a sequence whose items describe frames.
    void look_into(std::uint32_t length, const DataEncoding& encoding, int depth,
                   DicomHeader& header) {
        if (depth > deepest_nesting) throw Damaged();
        for_each(length, sequence_end, encoding, [&](const ElementHead& one) {
            if (one.tag != item) throw Damaged();
            for_each(one.length, item_end, encoding, [&](const ElementHead& head) {
                take_of_group(head, encoding, depth, header);
            });
        });
    }

    void take_of_group(const ElementHead& head, const DataEncoding& encoding, int depth,
                       DicomHeader& header) {
        const DataEncoding within = encoding_within(head, encoding);
        if (std::ranges::count(described_in, head.tag) > 0)
            return look_into(head.length, within, depth + 1, header);
        if (head.length == undefined_length) {
            skip_sequence(within, depth + 1);
            return;
        }
        const bool kept = std::ranges::count(group_values_kept, head.tag) > 0 &&
                          head.length <= longest_value &&
                          header.group_values[head.tag].size() < most_group_values;
        if (!kept) return skip(head.length);
        std::string value(head.length, '\0');
        read(value.data(), value.size());
        header.group_values[head.tag].push_back(std::move(value));
    }

    // Skips a sequence of undefined length; returns its number of items.
    std::size_t skip_sequence(const DataEncoding& encoding, int depth) {
        if (depth > deepest_nesting) throw Damaged();
        for (std::size_t items = 0;; ++items) {
            const ElementHead head = read_head(encoding);
            if (head.tag == sequence_end) return items;
            if (head.tag != item) throw Damaged();
            if (head.length == undefined_length)
                skip_item(encoding, depth);
            else
                skip(head.length);
        }
    }

    void skip_item(const DataEncoding& encoding, int depth) {
        for (;;) {
            const ElementHead head = read_head(encoding);
            if (head.tag == item_end) return;
            if (head.length == undefined_length)
                skip_sequence(encoding_within(head, encoding), depth + 1);
            else
                skip(head.length);
        }
    }

    // Reads the file meta group, if there is one; returns the encoding of the rest.
    DataEncoding begin(DicomHeader& header) {
        std::array<char, 132> head{};
        if (size_ >= head.size()) read(head.data(), head.size());
        if (std::string_view(head.data() + 128, 4) != "DICM") go_to(0);
        const DataEncoding meta;
        for (;;) {
            const std::uint64_t start = position_;
            const std::uint32_t group = word(2, false);
            go_to(start);
            if (group != 0x0002) break;
            take(read_head(meta), meta, header);
        }
        header.transfer_syntax = trimmed(header.values[transfer_syntax_uid]);
        if (header.transfer_syntax.empty()) return guessed_encoding();
        const std::string& syntax = header.transfer_syntax;
        return {syntax != "1.2.840.10008.1.2", syntax == "1.2.840.10008.1.2.2"};
    }

    // For old files without a meta group: two capital letters after the first tag are a value
    // representation.
    DataEncoding guessed_encoding() {
        const std::uint64_t start = position_;
        std::array<char, 6> bytes{};
        read(bytes.data(), bytes.size());
        go_to(start);
        const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
        return {is_capital(bytes[4]) && is_capital(bytes[5]), false};
    }

    void find_pixels(const ElementHead& head, DicomHeader& header) {
        header.has_pixels = true;
        header.pixel_offset = position_;
        header.compressed = head.length == undefined_length;
        if (!header.compressed) {
            header.pixel_bytes = head.length;
            return;
        }
        const DataEncoding little;
        bool is_offset_table = true;
        while (position_ < size_) {
            const ElementHead fragment = read_head(little);
            if (fragment.tag == sequence_end) return;
            if (fragment.tag != item || fragment.length == undefined_length) throw Damaged();
            if (!is_offset_table) header.fragments.push_back({position_, fragment.length});
            is_offset_table = false;
            skip(fragment.length);
        }
        throw Damaged();
    }

    std::istream& in_;
    std::uint64_t size_;
    std::uint64_t position_ = 0;
};

}  // namespace

bool DicomHeader::has(std::uint16_t group, std::uint16_t element) const {
    return values.contains(static_cast<std::uint32_t>(group) << 16 | element);
}

std::string DicomHeader::text(std::uint16_t group, std::uint16_t element) const {
    const auto found = values.find(static_cast<std::uint32_t>(group) << 16 | element);
    return found == values.end() ? "" : trimmed(found->second);
}

std::optional<std::vector<double>> DicomHeader::numbers_if_sound(std::uint16_t group,
                                                                 std::uint16_t element) const {
    std::string list = text(group, element);
    std::ranges::replace(list, '\\', ' ');
    return hepatica::numbers(list);
}

std::vector<double> DicomHeader::numbers(std::uint16_t group, std::uint16_t element) const {
    return numbers_if_sound(group, element).value_or(std::vector<double>{});
}

std::vector<std::vector<double>> DicomHeader::group_numbers(std::uint16_t group,
                                                            std::uint16_t element) const {
    std::vector<std::vector<double>> all;
    const auto found = group_values.find(static_cast<std::uint32_t>(group) << 16 | element);
    if (found == group_values.end()) return all;
    for (const std::string& value : found->second) {
        std::string list = trimmed(value);
        std::ranges::replace(list, '\\', ' ');
        all.push_back(hepatica::numbers(list).value_or(std::vector<double>{}));
    }
    return all;
}

std::string DicomHeader::group_text(std::uint16_t group, std::uint16_t element) const {
    const auto found = group_values.find(static_cast<std::uint32_t>(group) << 16 | element);
    return found == group_values.end() || found->second.empty() ? ""
                                                                : trimmed(found->second.front());
}

int DicomHeader::unsigned_short(std::uint16_t group, std::uint16_t element, int otherwise) const {
    const auto found = values.find(static_cast<std::uint32_t>(group) << 16 | element);
    if (found == values.end() || found->second.size() < 2) return otherwise;
    const auto first = static_cast<unsigned char>(found->second[0]);
    const auto second = static_cast<unsigned char>(found->second[1]);
    return big_endian ? first << 8 | second : second << 8 | first;
}

bool is_dicom_file(const fs::path& file) {
    std::error_code ignored;
    if (fs::is_other(fs::status(file, ignored))) return false;  // opening a pipe may wait for ever
    std::ifstream in(file, std::ios::binary);
    std::array<char, 132> head{};
    in.read(head.data(), head.size());
    if (in.gcount() == 132 && std::string_view(head.data() + 128, 4) == "DICM") return true;
    // Without a preamble a file begins with a short element of group 0002 or 0008.
    const bool tag = (head[0] == 2 || head[0] == 8) && head[1] == 0 && head[3] == 0;
    const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
    const bool vr = is_capital(head[4]) && is_capital(head[5]);
    const bool short_length = head[5] == 0 && head[6] == 0 && head[7] == 0;
    return in.gcount() == 132 && tag && (vr || short_length);
}

std::optional<DicomHeader> parse_dicom_header(std::istream& in, std::uint64_t size) {
    try {
        return Parser(in, size).parse();
    } catch (const Damaged&) {
        return std::nullopt;
    }
}

namespace {

// The inflated data after the file meta group of a deflated file (PS3.5 A.5); nothing if they are
// damaged or longer than 256 MiB.
std::optional<std::string> inflated_data(const fs::path& file, std::uint64_t from) {
    constexpr std::size_t most = std::size_t{1} << 28, part = std::size_t{1} << 20;
    try {
        ByteStream stream(file, from, Encoding::bare_deflated);
        std::string data;
        for (std::size_t got = part; got == part;) {
            if (data.size() > most) return std::nullopt;
            const std::size_t before = data.size();
            data.resize(before + part);
            got = stream.read_some(data.data() + before, part);
            data.resize(before + got);
        }
        return data;
    } catch (const InputError&) {
        return std::nullopt;
    }
}

bool add_deflated_data(const fs::path& file, DicomHeader& header) {
    const std::optional<std::string> data = inflated_data(file, header.deflated_at);
    if (!data) return false;
    std::istringstream in(*data);
    try {
        Parser(in, data->size()).parse_data({}, header);
    } catch (const Damaged&) {
        return false;
    }
    return true;
}

}  // namespace

std::optional<DicomHeader> read_dicom_header(const fs::path& file) {
    if (!is_dicom_file(file)) return std::nullopt;
    std::error_code error;
    const std::uint64_t size = fs::file_size(file, error);
    std::ifstream in(file, std::ios::binary);
    if (error || !in) return std::nullopt;
    std::optional<DicomHeader> header = parse_dicom_header(in, size);
    if (header && header->deflated_at > 0 && !add_deflated_data(file, *header)) return std::nullopt;
    return header;
}

}  // namespace hepatica
