// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's readers of XML files take what a file says of itself at its word and end the process, or
// read beyond their memory, where that is wrong. These look before and after.
#pragma once

#include <filesystem>

class vtkCellArray;

namespace hepatica {

// Before VTK reads the file: it is XML as VTK writes it, each of its arrays says what it holds, and
// no count is larger than the file could hold. Throws InputError that names the file. Costs a pass
// over the file's header, or over all of it where the numbers are text.
void check_vtk_xml(const std::filesystem::path& file);

// After VTK has read it: the offsets of the cells fit their connectivity, and every point that a
// cell names is one of `points`. Throws InputError that names the file.
void check_vtk_cells(vtkCellArray* cells, long long points, const std::filesystem::path& file);

}  // namespace hepatica
