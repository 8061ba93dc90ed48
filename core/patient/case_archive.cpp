// SPDX-License-Identifier: GPL-3.0-or-later
// Packs and unpacks zip archives with minizip, under the limits that the header names.
#include "core/patient/case_archive.h"

#include <minizip/unzip.h>
#include <minizip/zip.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/base/file_extension.h"
#include "core/base/flush_to_disk.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t most_bytes = std::uint64_t{4} << 30U;
constexpr std::uint64_t free_bytes = std::uint64_t{16} << 20U;
constexpr std::uint64_t most_expansion = 100;
constexpr unsigned long first_of_1980 = 0x00210000;  // the earliest date of a zip archive

using Buffer = std::array<char, 1 << 16>;

struct CloseUnzip {
    void operator()(void* file) const { unzClose(file); }
};
struct CloseZip {
    void operator()(void* file) const { zipClose(file, nullptr); }
};

[[noreturn]] void refuse(const fs::path& archive, const std::string& problem) {
    throw InputError(problem, archive.string(),
                     "Ask for the case again, or for its folder NAME.hep");
}

[[noreturn]] void refuse_to_write(const fs::path& archive) {
    throw InputError("cannot be written", archive.string(),
                     "Choose a folder you may write to, on a disk with room");
}

bool is_plain_name(const std::string& name) {
    const auto plain = [](unsigned char c) {
        return (std::isalnum(c) != 0 && c < 0x80) || c == '_' || c == '-' || c == '.';
    };
    return !name.empty() && name.size() <= 100 && name.front() != '.' &&
           std::ranges::all_of(name, plain);
}

// Unpacks one archive and counts the bytes.
class Unpacking {
  public:
    Unpacking(const fs::path& archive, const fs::path& folder)
        : archive_(archive), folder_(folder), zip_(unzOpen64(archive.c_str())) {
        if (zip_ == nullptr) refuse(archive, "is not a case in one file (.hepz), or is damaged");
        left_ = std::min(most_bytes, std::max(free_bytes, most_expansion * fs::file_size(archive)));
    }

    void all_files() {
        int status = unzGoToFirstFile(zip_.get());
        for (; status == UNZ_OK; status = unzGoToNextFile(zip_.get())) one_file();
        if (status != UNZ_END_OF_LIST_OF_FILE) refuse(archive_, "is damaged");
        if (names_.empty()) refuse(archive_, "is empty");
    }

  private:
    void one_file() {
        const std::string name = next_name();
        if (unzOpenCurrentFile(zip_.get()) != UNZ_OK) refuse(archive_, "is damaged at " + name);
        std::ofstream out(folder_ / name, std::ios::binary);
        Buffer buffer;
        int count = 0;
        while ((count = unzReadCurrentFile(zip_.get(), buffer.data(), buffer.size())) > 0) {
            if (static_cast<std::uint64_t>(count) > left_)
                refuse(archive_, "holds more than a case can: " + name + " is too large");
            left_ -= static_cast<std::uint64_t>(count);
            out.write(buffer.data(), count);
        }
        // Closing checks the checksum.
        if (count < 0 || unzCloseCurrentFile(zip_.get()) != UNZ_OK)
            refuse(archive_, "is damaged at " + name);
        out.close();
        if (!out)
            throw InputError("cannot be unpacked", archive_.string(),
                             "Free some space among the temporary files: " + folder_.string());
    }

    std::string next_name() {
        std::array<char, 256> text{};
        unz_file_info64 info;
        if (unzGetCurrentFileInfo64(zip_.get(), &info, text.data(), text.size() - 1, nullptr, 0,
                                    nullptr, 0) != UNZ_OK)
            refuse(archive_, "is damaged");
        std::string name(text.data(), std::min<std::size_t>(info.size_filename, 255));
        if (!is_plain_name(name))
            refuse(archive_, "holds a file whose name no file of a case has: \"" + name + "\"");
        if ((info.flag & 1U) != 0) refuse(archive_, "is encrypted");
        if (!names_.insert(name).second) refuse(archive_, "holds " + name + " twice");
        if (names_.size() > most_files_of_archive)
            refuse(archive_, "holds more files than a case can");
        return name;
    }

    fs::path archive_, folder_;
    std::unique_ptr<void, CloseUnzip> zip_;
    std::uint64_t left_ = 0;  // bytes that may still be unpacked
    std::set<std::string> names_;
};

std::vector<fs::path> sorted_files(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

// Returns whether all went well.
bool pack_file(void* zip, const fs::path& file) {
    zip_fileinfo info{};
    info.dosDate = first_of_1980;
    if (zipOpenNewFileInZip64(zip, file.filename().c_str(), &info, nullptr, 0, nullptr, 0, nullptr,
                              Z_DEFLATED, Z_DEFAULT_COMPRESSION, 1) != ZIP_OK)
        return false;
    std::ifstream in(file, std::ios::binary);
    Buffer buffer;
    bool good = in.is_open();
    while (good && in) {
        in.read(buffer.data(), buffer.size());
        good =
            zipWriteInFileInZip(zip, buffer.data(), static_cast<unsigned>(in.gcount())) == ZIP_OK;
    }
    return zipCloseFileInZip(zip) == ZIP_OK && good && in.eof();
}

}  // namespace

bool is_archive_name(const fs::path& place) {
    return extension_of(place) == ".hepz";
}

bool is_case_archive(const fs::path& place) {
    std::error_code ignored;
    return is_archive_name(place) && fs::is_regular_file(place, ignored);
}

void require_no_folder_at(const fs::path& archive) {
    if (std::error_code ignored; !fs::is_directory(archive, ignored)) return;
    throw InputError("is a folder, and no case in one file can take its place", archive.string(),
                     "Choose another name, or rename the folder or move it away");
}

bool archive_holds(const fs::path& archive, const char* name) {
    const std::unique_ptr<void, CloseUnzip> zip(unzOpen64(archive.c_str()));
    return zip != nullptr && unzLocateFile(zip.get(), name, 1) == UNZ_OK;
}

void unpack_case(const fs::path& archive, const fs::path& folder) {
    Unpacking(archive, folder).all_files();
}

void pack_case(const fs::path& folder, const fs::path& archive) {
    write_file_atomically(archive, [&](const fs::path& temporary) {
        std::unique_ptr<void, CloseZip> zip(zipOpen64(temporary.c_str(), APPEND_STATUS_CREATE));
        if (zip == nullptr) refuse_to_write(archive);
        for (const fs::path& file : sorted_files(folder))
            if (!pack_file(zip.get(), file)) refuse_to_write(archive);
        if (zipClose(zip.release(), nullptr) != ZIP_OK) refuse_to_write(archive);
        flush_to_disk(temporary, archive);
    });
}

}  // namespace hepatica
