// SPDX-License-Identifier: GPL-3.0-or-later
// Converts a surface that does not move to VTK polygons with smooth normals.
#pragma once

#include <vtkSmartPointer.h>

#include "core/mesh/tet_mesh.h"

class vtkPolyData;

namespace hepatica {

// Triangles must be counter-clockwise seen from outside.
vtkSmartPointer<vtkPolyData> still_surface(const TriangleMesh& surface);

}  // namespace hepatica
