// SPDX-License-Identifier: GPL-3.0-or-later
// Raw reads of a file, or zlib inflation through a 64 KiB input buffer.
#include "core/image/byte_stream.h"

#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

#include "core/base/error.h"
#include "core/base/regular_file.h"
#include "core/image/memory_limit.h"

namespace hepatica {

struct ByteStream::State {
    std::filesystem::path file;
    std::ifstream in;
    Encoding encoding = Encoding::raw;
    z_stream inflater{};
    bool member_ended = false;
    std::vector<unsigned char> input;
    std::uint64_t delivered = 0;

    std::size_t read_raw(void* buffer, std::size_t bytes) {
        in.read(static_cast<char*>(buffer), static_cast<std::streamsize>(bytes));
        if (in.bad())
            throw InputError("cannot be read to its end", file.string(), "Check the disk");
        return static_cast<std::size_t>(in.gcount());
    }

    // False at the end of the file.
    bool refill() {
        if (inflater.avail_in > 0) return true;
        inflater.next_in = input.data();
        inflater.avail_in = static_cast<uInt>(read_raw(input.data(), input.size()));
        return inflater.avail_in > 0;
    }

    std::size_t inflate_some(void* buffer, std::size_t bytes) {
        const uInt wanted = static_cast<uInt>(std::min<std::size_t>(bytes, 1u << 30));
        inflater.next_out = static_cast<Bytef*>(buffer);
        inflater.avail_out = wanted;
        while (inflater.avail_out > 0) {
            const bool has_input = refill();
            if (member_ended) {
                // gzip allows several members in a row; anything else after the first one is
                // padding.
                if (!has_input || encoding == Encoding::bare_deflated ||
                    inflater.next_in[0] != 0x1f)
                    break;
                inflateReset(&inflater);
                member_ended = false;
            }
            const uInt room = inflater.avail_out;
            const int status = inflate(&inflater, Z_NO_FLUSH);
            if (status == Z_STREAM_END)
                member_ended = true;
            else if (status != Z_OK && status != Z_BUF_ERROR)
                throw InputError("holds damaged compressed data after " +
                                     readable_bytes(delivered + wanted - inflater.avail_out),
                                 file.string(), "Copy or export the file again");
            // At the end of the file zlib may still hold output: a match of up to 258 bytes.
            if (!has_input && inflater.avail_out == room) break;
        }
        return wanted - inflater.avail_out;
    }
};

ByteStream::ByteStream(const std::filesystem::path& file, std::uint64_t offset, Encoding encoding)
    : state_(std::make_unique<State>()) {
    state_->file = file;
    state_->encoding = encoding;
    require_regular_file(file);
    state_->in.open(file, std::ios::binary);
    if (!state_->in)
        throw InputError(
            "cannot be opened (" + std::error_code(errno, std::generic_category()).message() + ")",
            file.string(), "Check that it exists and may be read");
    state_->in.seekg(static_cast<std::streamoff>(offset));
    if (encoding != Encoding::raw) {
        state_->input.resize(1 << 16);
        // +32: detect gzip or zlib by the header; negative: no header.
        inflateInit2(&state_->inflater, encoding == Encoding::deflated ? 15 + 32 : -15);
    }
}

ByteStream::~ByteStream() {
    if (state_->encoding != Encoding::raw) inflateEnd(&state_->inflater);
}

std::size_t ByteStream::read_some(void* buffer, std::size_t bytes) {
    std::size_t done = 0;
    auto* out = static_cast<unsigned char*>(buffer);
    while (done < bytes) {
        const std::size_t got = state_->encoding == Encoding::raw
                                    ? state_->read_raw(out + done, bytes - done)
                                    : state_->inflate_some(out + done, bytes - done);
        if (got == 0) break;
        done += got;
    }
    state_->delivered += done;
    return done;
}

void ByteStream::read(void* buffer, std::size_t bytes) {
    if (read_some(buffer, bytes) < bytes)
        throw InputError("ends too early, after " + readable_bytes(state_->delivered) + " of data",
                         state_->file.string(), "Copy or export the file again");
}

void ByteStream::skip(std::uint64_t bytes) {
    std::vector<unsigned char> waste(std::min<std::uint64_t>(bytes, 1 << 16));
    while (bytes > 0) {
        const std::size_t part = std::min<std::uint64_t>(bytes, waste.size());
        read(waste.data(), part);
        bytes -= part;
    }
}

}  // namespace hepatica
