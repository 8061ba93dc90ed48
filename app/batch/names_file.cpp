// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/names_file.h"

#include <system_error>

#include "app/batch/csv_cell.h"
#include "core/base/atomic_write.h"

namespace hepatica {

namespace fs = std::filesystem;

void write_names(const fs::path& out, const std::vector<BatchInput>& inputs) {
    std::string table = "patient,scan\n";
    for (const BatchInput& input : inputs)
        table += csv_cell(input.patient) + "," + csv_cell(input.scan) + "\n";
    const fs::path file = out / "names.csv";
    write_text_atomically(file, table);
    std::error_code ignored;  // some file systems know no owners
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write, ignored);
}

}  // namespace hepatica
