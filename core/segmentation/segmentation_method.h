// SPDX-License-Identifier: GPL-3.0-or-later
// The methods of vessel segmentation that are offered side by side and compared.
#pragma once

#include <string>

namespace hepatica {

enum class SegmentationMethod {
    multi_layer,  // 2-D cross-sections, layer by layer, assembled along their centreline
    vesselness,   // 3-D multi-scale Hessian, hysteresis, growth
    coherent,     // rise above the local parenchyma that continues along a line: the default
};

// The name used in files and tables.
inline std::string name_of(SegmentationMethod method) {
    switch (method) {
        case SegmentationMethod::multi_layer:
            return "multi_layer";
        case SegmentationMethod::vesselness:
            return "vesselness";
        case SegmentationMethod::coherent:
            break;
    }
    return "coherent";
}

}  // namespace hepatica
