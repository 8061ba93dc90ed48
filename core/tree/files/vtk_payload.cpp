// SPDX-License-Identifier: GPL-3.0-or-later
// Decodes base64, headers and compressed blocks.
#include "core/tree/files/vtk_payload.h"

#include <vtkLZ4DataCompressor.h>
#include <vtkSmartPointer.h>
#include <vtkZLibDataCompressor.h>

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

#include "core/base/base64.h"
#include "core/tree/files/vtk_errors.h"

namespace hepatica {

namespace {

// Deflate's longest match of 258 bytes takes at least two bits; LZ4 stays below a factor of 255.
constexpr std::size_t most_inflation = 1032;

[[noreturn]] void refuse(const std::string& problem) {
    throw std::invalid_argument(problem);
}

// Reads consecutive stretches of bytes from a text that may be base64.
class Stretches {
  public:
    Stretches(std::string_view data, bool base64) : rest_(data), base64_(base64) {}

    std::string next(std::size_t bytes) {
        const std::size_t taken = base64_ ? characters_of(bytes) : bytes;
        if (bytes > rest_.size() || taken > rest_.size())
            refuse("states " + std::to_string(bytes) + " bytes where " + std::to_string(left()) +
                   " are left");
        const std::string_view text = rest_.substr(0, taken);
        rest_.remove_prefix(taken);
        if (!base64_) return std::string(text);
        std::optional<std::string> decoded = from_base64(text);
        if (!decoded || decoded->size() < bytes) refuse("is no base64");
        decoded->resize(bytes);
        return *std::move(decoded);
    }

    // Peeks: the next call of next() returns the same bytes.
    std::string ahead(std::size_t bytes) const { return Stretches(*this).next(bytes); }

  private:
    static std::size_t characters_of(std::size_t bytes) {
        return bytes / 3 * 4 + (bytes % 3 ? 4 : 0);
    }
    std::size_t left() const { return base64_ ? rest_.size() / 4 * 3 : rest_.size(); }

    std::string_view rest_;
    bool base64_;
};

std::size_t number_at(std::string_view header, std::size_t index, const VtkEncoding& encoding) {
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < encoding.header_bytes; ++k) {
        const std::size_t digit = encoding.big_endian ? k : encoding.header_bytes - 1 - k;
        value =
            value << 8U | static_cast<unsigned char>(header[index * encoding.header_bytes + digit]);
    }
    return value;
}

void require_size(std::size_t bytes, std::optional<std::size_t> wanted) {
    if (wanted && bytes != *wanted)
        refuse("has " + std::to_string(bytes) + " bytes instead of " + std::to_string(*wanted));
}

std::string uncompressed(Stretches data, const VtkEncoding& encoding,
                         std::optional<std::size_t> wanted) {
    const std::size_t bytes = number_at(data.ahead(encoding.header_bytes), 0, encoding);
    require_size(bytes, wanted);
    if (bytes > std::numeric_limits<std::size_t>::max() - encoding.header_bytes)
        refuse("states " + std::to_string(bytes) + " bytes");
    return data.next(encoding.header_bytes + bytes).substr(encoding.header_bytes);
}

struct Blocks {
    std::size_t bytes_of_each = 0;
    std::size_t bytes_of_last = 0;
    std::vector<std::size_t> compressed_bytes;
};

Blocks blocks_of(Stretches& data, const VtkEncoding& encoding) {
    const std::string beginning = data.ahead(3 * encoding.header_bytes);
    const std::size_t count = number_at(beginning, 0, encoding);
    Blocks blocks;
    blocks.bytes_of_each = number_at(beginning, 1, encoding);
    blocks.bytes_of_last = number_at(beginning, 2, encoding);
    if (blocks.bytes_of_last > blocks.bytes_of_each)
        refuse("has a last block of " + std::to_string(blocks.bytes_of_last) +
               " bytes, larger than the others of " + std::to_string(blocks.bytes_of_each));
    if (blocks.bytes_of_last == 0) blocks.bytes_of_last = blocks.bytes_of_each;
    if (count > std::numeric_limits<std::uint32_t>::max())
        refuse("states " + std::to_string(count) + " blocks");
    const std::string header = data.next((3 + count) * encoding.header_bytes);
    for (std::size_t b = 0; b < count; ++b)
        blocks.compressed_bytes.push_back(number_at(header, 3 + b, encoding));
    return blocks;
}

vtkSmartPointer<vtkDataCompressor> made(VtkCompressor compressor) {
    if (compressor == VtkCompressor::lz4) return vtkSmartPointer<vtkLZ4DataCompressor>::New();
    return vtkSmartPointer<vtkZLibDataCompressor>::New();
}

std::string compressed(Stretches data, const VtkEncoding& encoding,
                       std::optional<std::size_t> wanted) {
    const Blocks blocks = blocks_of(data, encoding);
    std::size_t all = 0;
    for (const std::size_t bytes : blocks.compressed_bytes) all += bytes;
    const vtkSmartPointer<vtkDataCompressor> compressor = made(encoding.compressor);
    VtkErrors errors(compressor);
    std::string packed = data.next(all), bytes;
    std::size_t at = 0;
    for (std::size_t b = 0; b < blocks.compressed_bytes.size(); ++b) {
        const bool last = b + 1 == blocks.compressed_bytes.size();
        const std::size_t plain = last ? blocks.bytes_of_last : blocks.bytes_of_each;
        const std::size_t size = blocks.compressed_bytes[b];
        if (size > packed.size() - at || plain > most_inflation * size)
            refuse("states a block of " + std::to_string(plain) + " bytes in " +
                   std::to_string(size));
        if (wanted && plain > *wanted - bytes.size()) require_size(bytes.size() + plain, wanted);
        const std::size_t begin = bytes.size();
        bytes.resize(begin + plain);
        if (compressor->Uncompress(reinterpret_cast<const unsigned char*>(packed.data()) + at, size,
                                   reinterpret_cast<unsigned char*>(bytes.data()) + begin,
                                   plain) != plain)
            refuse("has a damaged block");
        at += size;
    }
    require_size(bytes.size(), wanted);
    return bytes;
}

}  // namespace

std::string vtk_payload(std::string_view data, const VtkEncoding& encoding,
                        std::optional<std::size_t> bytes) {
    const Stretches stretches(data, encoding.base64);
    return encoding.compressor == VtkCompressor::none ? uncompressed(stretches, encoding, bytes)
                                                      : compressed(stretches, encoding, bytes);
}

}  // namespace hepatica
