// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/dicom_header.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

#include "core/image/header_text.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

constexpr std::uint32_t undefined_length = 0xffffffff;
constexpr std::uint32_t longest_value = 4096;
constexpr int deepest_nesting = 32;

constexpr std::uint32_t pixel_data = 0x7fe00010;
constexpr std::uint32_t transfer_syntax_uid = 0x00020010;
constexpr std::uint32_t item = 0xfffee000;
constexpr std::uint32_t item_end = 0xfffee00d;
constexpr std::uint32_t sequence_end = 0xfffee0dd;

// The file is not what it claims to be.
struct Damaged {};

struct Encoding {
    bool explicit_vr = true;
    bool big_endian = false;
};

struct ElementHead {
    std::uint32_t tag = 0;
    std::array<char, 2> vr{' ', ' '};
    std::uint32_t length = 0;
};

class Parser {
  public:
    Parser(std::ifstream& in, std::uint64_t size) : in_(in), size_(size) {}

    DicomHeader parse() {
        DicomHeader header;
        Encoding encoding = begin(header);
        header.big_endian = encoding.big_endian;
        while (position_ < size_) {
            const ElementHead head = read_head(encoding);
            if (head.tag == pixel_data) {
                find_pixels(head, header);
                break;
            }
            take(head, encoding, header);
        }
        return header;
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

    ElementHead read_head(const Encoding& encoding) {
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

    // Keeps short values, steps over the rest.
    void take(const ElementHead& head, const Encoding& encoding, DicomHeader& header) {
        if (head.length == undefined_length) {
            // A sequence of unknown kind is encoded without value representations.
            const bool unknown = head.vr[0] == 'U';
            skip_sequence({encoding.explicit_vr && !unknown, encoding.big_endian}, 0);
        } else if (head.length > longest_value || head.vr == std::array<char, 2>{'S', 'Q'}) {
            skip(head.length);
        } else {
            std::string value(head.length, '\0');
            read(value.data(), value.size());
            header.values[head.tag] = std::move(value);
        }
    }

    void skip_sequence(const Encoding& encoding, int depth) {
        if (depth > deepest_nesting) throw Damaged();
        for (;;) {
            const ElementHead head = read_head(encoding);
            if (head.tag == sequence_end) return;
            if (head.tag != item) throw Damaged();
            if (head.length == undefined_length)
                skip_item(encoding, depth);
            else
                skip(head.length);
        }
    }

    void skip_item(const Encoding& encoding, int depth) {
        for (;;) {
            const ElementHead head = read_head(encoding);
            if (head.tag == item_end) return;
            if (head.length == undefined_length)
                skip_sequence(encoding, depth + 1);
            else
                skip(head.length);
        }
    }

    // Reads the file meta group, if there is one, and tells how the rest is encoded.
    Encoding begin(DicomHeader& header) {
        std::array<char, 132> head{};
        if (size_ >= head.size()) read(head.data(), head.size());
        if (std::string_view(head.data() + 128, 4) != "DICM") go_to(0);
        const Encoding meta;
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
        if (syntax == "1.2.840.10008.1.2.1.99") throw Damaged();  // the whole file is deflated
        return {syntax != "1.2.840.10008.1.2", syntax == "1.2.840.10008.1.2.2"};
    }

    // Old files do not say: two capital letters after the tag are a value representation.
    Encoding guessed_encoding() {
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
        const Encoding little;
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

    std::ifstream& in_;
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

std::vector<double> DicomHeader::numbers(std::uint16_t group, std::uint16_t element) const {
    std::string list = text(group, element);
    std::ranges::replace(list, '\\', ' ');
    return hepatica::numbers(list).value_or(std::vector<double>{});
}

int DicomHeader::unsigned_short(std::uint16_t group, std::uint16_t element, int otherwise) const {
    const auto found = values.find(static_cast<std::uint32_t>(group) << 16 | element);
    if (found == values.end() || found->second.size() < 2) return otherwise;
    const auto first = static_cast<unsigned char>(found->second[0]);
    const auto second = static_cast<unsigned char>(found->second[1]);
    return big_endian ? first << 8 | second : second << 8 | first;
}

bool is_dicom_file(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::array<char, 132> head{};
    in.read(head.data(), head.size());
    if (in.gcount() == 132 && std::string_view(head.data() + 128, 4) == "DICM") return true;
    // Without a preamble a file begins with a short element of group 0002 or 0008.
    const bool tag = (head[0] == 2 || head[0] == 8) && head[1] == 0 && head[3] == 0;
    const bool vr = head[4] >= 'A' && head[4] <= 'Z' && head[5] >= 'A' && head[5] <= 'Z';
    const bool short_length = head[5] == 0 && head[6] == 0 && head[7] == 0;
    return in.gcount() == 132 && tag && (vr || short_length);
}

std::optional<DicomHeader> read_dicom_header(const fs::path& file) {
    if (!is_dicom_file(file)) return std::nullopt;
    std::error_code error;
    const std::uint64_t size = fs::file_size(file, error);
    std::ifstream in(file, std::ios::binary);
    if (error || !in) return std::nullopt;
    try {
        return Parser(in, size).parse();
    } catch (const Damaged&) {
        return std::nullopt;
    }
}

}  // namespace hepatica
