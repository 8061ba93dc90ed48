// SPDX-License-Identifier: GPL-3.0-or-later
// OpenGL without any display: a software context for programs that make pictures on servers. Only
// programs that link hepatica_osmesa have it; it takes over the look-up of OpenGL's functions, so
// the desktop program must not.
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkSmartPointer.h>

#include <memory>

namespace hepatica {

// A picture of fixed size in memory. The thread that made it must use and destroy it.
class OsmesaContext {
  public:
    // 1 to 16384 pixels each way; throws Error (naming the driver) where none can be made.
    OsmesaContext(int width, int height);
    ~OsmesaContext();
    OsmesaContext(const OsmesaContext&) = delete;
    OsmesaContext& operator=(const OsmesaContext&) = delete;

    vtkGenericOpenGLRenderWindow& window() { return *window_; }

  private:
    struct Buffer;
    std::unique_ptr<Buffer> buffer_;
    vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
};

}  // namespace hepatica
