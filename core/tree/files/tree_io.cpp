// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/files/tree_io.h"

#include "core/base/error.h"
#include "core/base/text_file.h"
#include "core/tree/files/tree_files.h"

namespace hepatica {

std::string read_text(const std::filesystem::path& file) {
    return read_text_file(file, "Give a tree in a .vtp, .swc or .json file");
}

void validate_from_file(const VesselTree& tree, const std::filesystem::path& file) {
    try {
        validate(tree);
    } catch (const InputError& error) {
        throw InputError(error.place() + " " + error.problem(), file.string(), error.remedy());
    }
}

namespace {

[[noreturn]] void refuse_extension(const std::filesystem::path& file) {
    throw InputError("is no format of vessel trees", file.string(),
                     "Choose a name that ends in .vtp, .swc or .json");
}

}  // namespace

void write_tree(const std::filesystem::path& file, const VesselTree& tree) {
    const std::string extension = file.extension().string();
    if (extension == ".vtp") return write_tree_vtp(file, tree);
    if (extension == ".swc") return write_tree_swc(file, tree);
    if (extension == ".json") return write_tree_json(file, tree);
    refuse_extension(file);
}

VesselTree read_tree(const std::filesystem::path& file) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        throw InputError("does not exist", file.string(),
                         "Give a tree in a .vtp, .swc or .json file");
    const std::string extension = file.extension().string();
    if (extension == ".vtp") return read_tree_vtp(file);
    if (extension == ".swc") return read_tree_swc(file);
    if (extension == ".json") return read_tree_json(file);
    refuse_extension(file);
}

}  // namespace hepatica
