// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/files/vtk_errors.h"

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkNew.h>

namespace hepatica {

VtkErrors::VtkErrors(vtkObject* object) {
    vtkNew<vtkCallbackCommand> heard;
    heard->SetClientData(&any_);
    heard->SetCallback(
        [](vtkObject*, unsigned long, void* any, void*) { *static_cast<bool*>(any) = true; });
    hear(object, heard);
    // It tells once more that the algorithm failed.
    if (auto* const algorithm = vtkAlgorithm::SafeDownCast(object))
        hear(algorithm->GetExecutive(), heard);
}

VtkErrors::~VtkErrors() {
    for (const auto& [object, tag] : observers_) object->RemoveObserver(tag);
}

void VtkErrors::hear(vtkObject* object, vtkCommand* heard) {
    observers_.emplace_back(object, object->AddObserver(vtkCommand::ErrorEvent, heard));
}

}  // namespace hepatica
