// SPDX-License-Identifier: GPL-3.0-or-later
// The patients in a folder of CTs: each a DICOM folder or a volume file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace hepatica {

struct BatchInput {
    std::string patient;  // name in files and tables: the scan's name, or a pseudonym
    std::string scan;     // the folder's or file's name, without the ending of a volume
    std::filesystem::path ct;
    std::optional<std::filesystem::path> liver_mask;
};

// Sorted by name. Hidden entries and files of other kinds are skipped; files whose names differ
// only in the ending keep it. `liver_masks`, where not empty, is a folder in which the file with a
// patient's name (and the ending of a volume) is that patient's liver mask. Throws InputError where
// a folder cannot be read, and where `folder` holds no CT.
std::vector<BatchInput> batch_inputs(const std::filesystem::path& folder,
                                     const std::filesystem::path& liver_masks);

// Names every patient "P-" and the first eight digits of the SHA-256 of the scan's name, which
// reveals nothing and is the same in every call. If two names share these digits, the later one
// gets more digits.
void use_pseudonyms(std::vector<BatchInput>& inputs);

// Every count-th input, starting with the number-th (1 <= number <= count). The shares are disjoint
// and together complete.
std::vector<BatchInput> share_of(const std::vector<BatchInput>& inputs, int number, int count);

}  // namespace hepatica
