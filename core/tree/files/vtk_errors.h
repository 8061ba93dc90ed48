// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of VTK's readers and writers, of which a message of our own tells: VTK would also write
// them to the terminal.
#pragma once

#include <utility>
#include <vector>

class vtkCommand;
class vtkObject;

namespace hepatica {

// Hears the errors of one object while both live, and of the pipeline that drives it: VTK is silent
// about what is heard. Any number of threads may have some, each for an object of its own.
class VtkErrors {
  public:
    explicit VtkErrors(vtkObject* object);
    ~VtkErrors();
    VtkErrors(const VtkErrors&) = delete;
    VtkErrors& operator=(const VtkErrors&) = delete;

    bool any() const { return any_; }

  private:
    void hear(vtkObject* object, vtkCommand* heard);

    std::vector<std::pair<vtkObject*, unsigned long>> observers_;
    bool any_ = false;
};

}  // namespace hepatica
