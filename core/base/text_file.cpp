// SPDX-License-Identifier: GPL-3.0-or-later
// Unformatted reads; a read that fails sets the stream's badbit, the end of the file does not.
#include "core/base/text_file.h"

#include <cerrno>
#include <fstream>
#include <system_error>

#include "core/base/error.h"
#include "core/base/json_depth.h"
#include "core/base/regular_file.h"

namespace hepatica {

namespace {

// 0 where it has none, as pipes and the files of /proc.
std::uint64_t bytes_of(std::ifstream& in) {
    in.seekg(0, std::ios::end);
    const std::streamoff bytes = in.tellg();
    in.clear();
    in.seekg(0);
    in.clear();
    return bytes > 0 ? static_cast<std::uint64_t>(bytes) : 0;
}

std::string why_unread() {
    if (errno == 0) return "cannot be read to its end";
    return "cannot be read (" + std::generic_category().message(errno) + ")";
}

// Whether the text begins as a JSON list or object, perhaps after a byte order mark.
bool looks_like_json(const std::string& text) {
    constexpr const char* spaces_and_mark = " \t\r\n\xef\xbb\xbf";
    const std::size_t first = text.find_first_not_of(spaces_and_mark);
    return first != std::string::npos && (text[first] == '{' || text[first] == '[');
}

}  // namespace

std::string read_text_file(const std::filesystem::path& file, const std::string& remedy) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        throw InputError("does not exist", file.string(), remedy);
    require_regular_file(file, remedy);
    std::ifstream in(file, std::ios::binary);
    if (!in) throw InputError("cannot be read; check its permissions", file.string(), remedy);
    const std::uint64_t bytes = bytes_of(in);
    std::string text = read_text_stream(in, bytes, file);
    if (looks_like_json(text) && nests_too_deep(text))
        throw InputError("nests lists and objects deeper than any file of this program",
                         file.string(), remedy);
    return text;
}

std::string read_text_stream(std::istream& in, std::uint64_t least_bytes,
                             const std::filesystem::path& file) {
    constexpr std::size_t block_bytes = 1 << 16;
    std::string text;
    while (in) {
        const std::size_t before = text.size();
        text.resize(before + block_bytes);
        errno = 0;
        in.read(text.data() + before, static_cast<std::streamsize>(block_bytes));
        if (in.bad()) throw InputError(why_unread(), file.string(), "Check the disk");
        text.resize(before + static_cast<std::size_t>(in.gcount()));
    }
    if (text.size() < least_bytes)
        throw InputError("ended after " + std::to_string(text.size()) + " of " +
                             std::to_string(least_bytes) + " bytes: it was cut while it was read",
                         file.string(), "Read it again when no other program writes it");
    return text;
}

}  // namespace hepatica
