// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/batch_inputs.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <system_error>

#include "core/base/error.h"
#include "core/base/sha256.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 7> endings{".nii.gz", ".nii",  ".mha", ".mhd",
                                                  ".nrrd",   ".nhdr", ".dcm"};

// The name without the ending of a volume file; none where it has no such ending.
std::optional<std::string> stem_of_volume(const std::string& name) {
    for (const std::string_view ending : endings)
        if (name.size() > ending.size() && name.ends_with(ending))
            return name.substr(0, name.size() - ending.size());
    return std::nullopt;
}

std::vector<fs::path> entries_of(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> entries;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        entries.push_back(at->path());
    if (error)
        throw InputError("cannot be read: " + error.message(), folder.string(),
                         "Name a folder that holds CTs");
    std::ranges::sort(entries);
    return entries;
}

// Volumes by patient name; of several with one name the first.
std::map<std::string, fs::path> volumes_by_name(const fs::path& folder) {
    std::map<std::string, fs::path> volumes;
    for (const fs::path& entry : entries_of(folder))
        if (const auto stem = stem_of_volume(entry.filename().string()))
            volumes.emplace(*stem, entry);
    return volumes;
}

// Inputs of the same name get the full names of their files, which may in turn be the names of
// others: a.nii and a.mha beside a.nii.mha.
void make_names_differ(std::vector<BatchInput>& inputs) {
    for (bool changed = true; changed;) {
        changed = false;
        std::map<std::string, int> uses;
        for (const BatchInput& input : inputs) ++uses[input.scan];
        for (BatchInput& input : inputs) {
            const std::string full = input.ct.filename().string();
            if (uses[input.scan] == 1 || input.scan == full) continue;
            input.patient = input.scan = full;
            changed = true;
        }
    }
}

}  // namespace

std::vector<BatchInput> batch_inputs(const fs::path& folder, const fs::path& liver_masks) {
    std::vector<BatchInput> inputs;
    for (const fs::path& entry : entries_of(folder)) {
        const std::string name = entry.filename().string();
        if (name.starts_with('.')) continue;
        const bool is_folder = fs::is_directory(entry);
        const auto stem = is_folder ? name : stem_of_volume(name);
        if (!stem) continue;
        inputs.push_back({*stem, *stem, entry, std::nullopt});
    }
    if (inputs.empty())
        throw InputError("holds no CT", folder.string(),
                         "Give a folder of DICOM folders or of .nii, .nii.gz, .mha, .nrrd files");
    const auto masks =
        liver_masks.empty() ? std::map<std::string, fs::path>{} : volumes_by_name(liver_masks);
    for (BatchInput& input : inputs)
        if (const auto mask = masks.find(input.patient); mask != masks.end())
            input.liver_mask = mask->second;
    make_names_differ(inputs);
    return inputs;
}

void use_pseudonyms(std::vector<BatchInput>& inputs) {
    std::set<std::string> taken;
    for (BatchInput& input : inputs) {
        Sha256 hash;
        hash.add_bytes(input.scan.data(), input.scan.size());
        const std::string digest = hash.hex_digest();
        std::size_t digits = 8;
        while (!taken.insert("P-" + digest.substr(0, digits)).second) ++digits;
        input.patient = "P-" + digest.substr(0, digits);
    }
}

std::vector<BatchInput> share_of(const std::vector<BatchInput>& inputs, int number, int count) {
    std::vector<BatchInput> share;
    for (std::size_t i = static_cast<std::size_t>(number) - 1; i < inputs.size();
         i += static_cast<std::size_t>(count))
        share.push_back(inputs[i]);
    return share;
}

}  // namespace hepatica
