// SPDX-License-Identifier: GPL-3.0-or-later
// The patients of a folder of CTs: each a DICOM folder or a volume file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace hepatica {

struct BatchInput {
    std::string patient;  // what files and tables call him: the scan's name, or a pseudonym
    std::string scan;     // the folder's or file's name, without a volume's ending
    std::filesystem::path ct;
    std::optional<std::filesystem::path> liver_mask;
};

// In the order of their names. Hidden entries and files of other kinds are passed over; two files
// whose names differ in their ending alone keep it. `liver_masks`, where not empty, is a folder of
// which the file with a patient's name (and a volume's ending) is his liver mask.
// Throws InputError where a folder cannot be read, and where `folder` holds no CT.
std::vector<BatchInput> batch_inputs(const std::filesystem::path& folder,
                                     const std::filesystem::path& liver_masks);

// Calls every patient P- and the first eight digits of the SHA-256 of his scan's name, which says
// nothing to a reader and is the same in every call; of two names with the same digits the later
// one gets more of them.
void use_pseudonyms(std::vector<BatchInput>& inputs);

// Every count-th of them, from the number-th on (1 <= number <= count): all shares together are the
// whole, without overlap.
std::vector<BatchInput> share_of(const std::vector<BatchInput>& inputs, int number, int count);

}  // namespace hepatica
