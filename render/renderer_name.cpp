// SPDX-License-Identifier: GPL-3.0-or-later
// Name of the OpenGL renderer in use, declared in scene_view.h.
#include <vtkRenderWindow.h>

#include "render/scene_view.h"

namespace hepatica {

std::string renderer_name(vtkRenderWindow& window) {
    const std::string report = window.ReportCapabilities();
    const std::string key = "OpenGL renderer string:";
    const std::size_t found = report.find(key);
    if (found == std::string::npos) return {};
    const std::size_t begin = report.find_first_not_of(' ', found + key.size());
    return report.substr(begin, report.find('\n', begin) - begin);
}

bool is_software_renderer(const std::string& renderer_name) {
    for (const char* name : {"llvmpipe", "softpipe", "swrast", "SWR", "Software"}) {
        if (renderer_name.find(name) != std::string::npos) return true;
    }
    return false;
}

}  // namespace hepatica
