// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/body/element_name.h"

#include "core/base/error.h"

namespace hepatica {
namespace {

struct Entry {
    const char* name;
    ElementModel model;
    ElementOrder order;
};

constexpr Entry entries[] = {
    {"spring", ElementModel::spring, ElementOrder::linear},
    {"corotated", ElementModel::corotated, ElementOrder::linear},
    {"neohookean", ElementModel::neohookean, ElementOrder::linear},
    {"corotated-10", ElementModel::corotated, ElementOrder::quadratic},
    {"neohookean-10", ElementModel::neohookean, ElementOrder::quadratic},
};

}  // namespace

std::string element_name(ElementModel model, ElementOrder order) {
    for (const Entry& entry : entries)
        if (entry.model == model && entry.order == order) return entry.name;
    return "unknown";
}

std::pair<ElementModel, ElementOrder> element_of(const std::string& name) {
    for (const Entry& entry : entries)
        if (name == entry.name) return {entry.model, entry.order};
    throw UsageError("there is no element \"" + name + "\"", "",
                     "Choose spring, corotated, neohookean, corotated-10 or neohookean-10.");
}

}  // namespace hepatica
