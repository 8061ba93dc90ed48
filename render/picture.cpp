// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/picture.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cstddef>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/tree/files/vtk_errors.h"

namespace hepatica {
namespace {

// VTK stores rows from the bottom upwards.
std::size_t bottom_up_row(const Picture& picture, int row) {
    return static_cast<std::size_t>(picture.height - 1 - row) *
           static_cast<std::size_t>(picture.width) * 3;
}

std::size_t row_bytes(const Picture& picture) {
    return static_cast<std::size_t>(picture.width) * 3;
}

Picture flipped(int width, int height, const std::uint8_t* rows_from_bottom) {
    Picture picture{width, height, {}};
    picture.rgb.resize(row_bytes(picture) * static_cast<std::size_t>(height));
    for (int row = 0; row < height; ++row) {
        std::copy_n(rows_from_bottom + bottom_up_row(picture, row), row_bytes(picture),
                    picture.rgb.data() + static_cast<std::size_t>(row) * row_bytes(picture));
    }
    return picture;
}

}  // namespace

Picture read_picture(vtkRenderWindow& window) {
    const int width = window.GetSize()[0];
    const int height = window.GetSize()[1];
    vtkNew<vtkUnsignedCharArray> pixels;
    window.GetPixelData(0, 0, width - 1, height - 1, 0, pixels);
    return flipped(width, height, pixels->GetPointer(0));
}

void write_png(const std::filesystem::path& file, const Picture& picture) {
    vtkNew<vtkImageData> image;
    image->SetDimensions(picture.width, picture.height, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* out = static_cast<std::uint8_t*>(image->GetScalarPointer());
    for (int row = 0; row < picture.height; ++row) {
        std::copy_n(picture.rgb.data() + static_cast<std::size_t>(row) * row_bytes(picture),
                    row_bytes(picture), out + bottom_up_row(picture, row));
    }
    write_file_atomically(file, [&](const std::filesystem::path& temporary) {
        vtkNew<vtkPNGWriter> writer;
        VtkErrors errors(writer);
        writer->SetInputData(image);
        writer->SetFileName(temporary.c_str());
        writer->Write();
        if (errors.any() || writer->GetErrorCode() != 0) {
            throw InputError("the picture cannot be written", file.string(),
                             "choose a folder you may write to, on a disk with room");
        }
    });
}

Picture read_png(const std::filesystem::path& file) {
    vtkNew<vtkPNGReader> reader;
    VtkErrors errors(reader);
    const bool readable =
        std::filesystem::is_regular_file(file) && reader->CanReadFile(file.c_str());
    if (readable) {
        reader->SetFileName(file.c_str());
        reader->Update();
    }
    vtkImageData* image = readable ? reader->GetOutput() : nullptr;
    if (!image || image->GetScalarType() != VTK_UNSIGNED_CHAR ||
        image->GetNumberOfScalarComponents() != 3) {
        throw InputError("not a PNG picture of 8-bit colours", file.string(), "give a PNG file");
    }
    const int* dims = image->GetDimensions();
    return flipped(dims[0], dims[1], static_cast<const std::uint8_t*>(image->GetScalarPointer()));
}

}  // namespace hepatica
