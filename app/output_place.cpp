// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output_place.h"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "core/base/error.h"
#include "core/base/file_extension.h"
#include "core/base/linked_place.h"
#include "core/base/special_file.h"
#include "core/patient/case_digest.h"
#include "core/patient/patient_case.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

fs::path without_trailing_slash(const fs::path& path) {
    return path.has_filename() ? path : path.parent_path();
}

// Of a folder's name with a slash at its end, too.
std::string ending_of(const fs::path& path) {
    return extension_of(without_trailing_slash(path));
}

}  // namespace

void require_writable(const fs::path& place) {
    if (std::error_code ignored;
        !place.has_filename() && fs::is_regular_file(without_trailing_slash(place), ignored))
        throw InputError("is a file and no folder", place.string(),
                         "Leave the slash at its end out, or name another folder");
    std::error_code ignored;
    fs::path target = without_trailing_slash(fs::absolute(place));
    if (fs::is_symlink(fs::symlink_status(target, ignored))) target = place_behind_links(target);
    const fs::path folder = target.parent_path();
    fs::path above = folder;
    int missing = 0;
    for (; !fs::exists(above, ignored) && above.has_relative_path(); ++missing)
        above = above.parent_path();
    if (!fs::is_directory(above, ignored))
        throw InputError("cannot be created: " + above.string() + " is not a folder",
                         place.string(), "Choose another place");
    if (access(above.c_str(), W_OK | X_OK) != 0)
        throw InputError("cannot be created: " + std::generic_category().message(errno) + " (" +
                             above.string() + ")",
                         place.string(), "Choose a folder that you may write to");
    if (missing > 1)
        throw InputError("cannot be created: there is no folder " + folder.parent_path().string(),
                         place.string(), "Check the path, or make that folder first");
    if (missing == 1) spdlog::info("the folder {} is made", folder.string());
}

void require_writable_file(const fs::path& file, const std::string& ending) {
    if (const std::string named = ending_of(file); !named.empty() && named != ending)
        throw UsageError("a \"" + ending + "\" file is written, and not a \"" + named + "\" file",
                         file.string(), "Name a file that ends in " + ending);
    if (std::error_code ignored; fs::is_directory(file, ignored))
        throw InputError("is a folder", file.string(), "Name a file");
    if (!is_special_file(file)) return require_writable(file);
    if (access(file.c_str(), W_OK) != 0)
        throw InputError("cannot be written (" + std::generic_category().message(errno) + ")",
                         file.string(), "Choose another place");
}

void require_growing_file(const fs::path& file, const std::string& ending) {
    require_writable_file(file, ending);
    if (is_special_file(file))
        throw InputError("is a pipe, a socket or a device, not a file", file.string(),
                         "Name a file");
}

void require_different(const std::vector<fs::path>& files) {
    for (std::size_t i = 0; i < files.size(); ++i)
        for (std::size_t k = 0; k < i && !files[i].empty() && !is_special_file(files[i]); ++k)
            if (!files[k].empty() && fs::weakly_canonical(fs::absolute(files[k])) ==
                                         fs::weakly_canonical(fs::absolute(files[i])))
                throw UsageError("is named twice", files[i].string(),
                                 "Give each output a file of its own");
}

void require_writable_folder(const fs::path& folder) {
    require_writable(fs::exists(folder) ? folder / "file" : folder);
}

void require_empty_or_new(const fs::path& folder) {
    if (!fs::exists(folder)) return;
    if (!fs::is_directory(folder))
        throw InputError("is a file and no folder", folder.string(), "Name a new folder");
    if (!fs::is_empty(folder))
        throw InputError("is not empty", folder.string(), "Name a new folder, or an empty one");
}

void require_case_name(const fs::path& place) {
    const std::string extension = ending_of(place);
    if (extension.empty() || extension == ".hep" || extension == ".hepz") return;
    const std::string name = without_trailing_slash(place).stem().string();
    throw UsageError("a case is a folder and not a \"" + extension + "\" file", place.string(),
                     "Name it " + name + ".hep, or " + name + ".hepz for one file");
}

void require_case_place(const fs::path& place) {
    require_case_name(place);
    require_writable(place);
    require_place_of_case(without_trailing_slash(place));
}

void require_replaceable_case(const fs::path& place) {
    if (!is_replaceable_case(place)) return require_place_of_case(without_trailing_slash(place));
    try {
        const std::size_t edits = read_case_without_voxels(place).corrections.edits.size();
        if (edits > 0)
            spdlog::warn(
                "{} holds corrections ({}), which a new case in its place will not have; Ctrl-C "
                "leaves it as it is",
                place.string(), edits);
    } catch (const Error&) {  // nothing of it can be used
    }
}

void require_same_patient_at(const fs::path& place, const PatientCase& patient, bool may_replace) {
    if (may_replace || !is_replaceable_case(place) || is_case_of(place, patient)) return;
    throw InputError("holds a case already that is not known to be of this patient", place.string(),
                     "Give --out another name, or --replace if that one is to go");
}

bool is_in_place(const fs::path& out, const fs::path& place) {
    std::error_code not_there;
    return out.empty() || fs::equivalent(out, place, not_there);
}

void require_as_read(const fs::path& place, const std::string& digest) {
    if (digest_of_case(place) == digest) return;
    throw InputError("was changed by another program since it was read; nothing is written",
                     place.string(), "Do it again, or give --out another name");
}

void require_png_name(const fs::path& file) {
    if (ending_of(file) == ".png") return;
    throw UsageError("a picture is written as PNG and not as \"" + ending_of(file) + "\"",
                     file.string(), "Name a file that ends in .png");
}

void require_own_or_new(const fs::path& folder, const fs::path& mark) {
    if (!fs::exists(folder) || fs::exists(folder / mark)) return;
    if (fs::is_directory(folder) && fs::is_empty(folder)) return;
    throw InputError("is there already and was not made by this verb", folder.string(),
                     "Choose another name or remove it");
}

}  // namespace hepatica
