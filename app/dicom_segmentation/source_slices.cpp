// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dicom_segmentation/source_slices.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "app/dicom_segmentation/order.h"

namespace hepatica::dicom_segmentation {

namespace {

constexpr Uint32 longest_in_memory = 4096;  // pixels stay in the file

Refusal lacks(const std::string& file, const std::string& what) {
    return {"cannot refer to " + file + ": it has no " + what,
            "Export the CT again from the archive, with its identifiers"};
}

void load(DcmFileFormat& format, const std::string& file) {
    const OFCondition loaded =
        format.loadFile(file.c_str(), EXS_Unknown, EGL_noChange, longest_in_memory);
    if (loaded.bad())
        throw Refusal{"cannot refer to " + file + " (" + loaded.text() + ")",
                      "Check that the CT's files are still there"};
}

SourceSlice described(DcmDataset& data, const std::string& file) {
    SourceSlice slice;
    data.findAndGetOFString(DCM_SOPClassUID, slice.sop_class);
    data.findAndGetOFString(DCM_SOPInstanceUID, slice.sop_instance);
    if (slice.sop_class.empty() || slice.sop_instance.empty())
        throw lacks(file, "SOP class and instance UID (0008,0016 and 0008,0018)");
    for (unsigned long axis = 0; axis < 3; ++axis) {
        OFString text;
        if (data.findAndGetOFString(DCM_ImagePositionPatient, text, axis).bad() || text.empty())
            throw lacks(file, "position (0020,0032)");
        slice.position[axis] = decimal(std::atof(text.c_str()));
    }
    return slice;
}

// Anonymisers leave text where the standard requires codes and dates, which DCMTK then refuses to
// write. Malformed values of patient and examination are removed.
void drop_malformed(DcmDataset& data) {
    for (unsigned long i = data.card(); i-- > 0;) {
        DcmElement* const element = data.getElement(i);
        const Uint16 group = element->getGTag();
        if ((group == 0x0008 || group == 0x0010) && element->isLeaf() &&
            element->checkValue("1-n").bad())
            delete data.remove(i);
    }
}

}  // namespace

OFString decimal(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.10g", value == 0.0 ? 0.0 : value);
    return text.data();
}

SourceSlices::SourceSlices(const std::vector<std::string>& files) {
    load(first_, files.front());
    for (const std::string& file : files) {
        DcmFileFormat format;
        load(format, file);
        slices_.push_back(described(*format.getDataset(), file));
    }
    for (const auto& [element, words] :
         {std::pair{DCM_StudyInstanceUID, "study instance UID (0020,000d)"},
          std::pair{DCM_SeriesInstanceUID, "series instance UID (0020,000e)"}})
        if (text(element).empty()) throw lacks(files.front(), words);
    drop_malformed(first());
    first().findAndGetUint16(DCM_Rows, rows_);
    first().findAndGetUint16(DCM_Columns, columns_);
}

OFString SourceSlices::text(const DcmTagKey& element, unsigned long index) const {
    OFString value;
    first_.getDataset()->findAndGetOFString(element, value, index);
    return value;
}

OFString SourceSlices::number(const DcmTagKey& element, unsigned long index) const {
    const OFString value = text(element, index);
    return value.empty() ? value : decimal(std::atof(value.c_str()));
}

double SourceSlices::spacing_mm() const {
    if (slices_.size() == 1) {
        const double thickness = std::atof(text(DCM_SliceThickness).c_str());
        if (!(thickness > 0.0)) throw lacks("the CT's only slice", "slice thickness (0018,0050)");
        return thickness;
    }
    std::array<double, 6> axes{};
    for (unsigned long i = 0; i < axes.size(); ++i)
        axes[i] = std::atof(text(DCM_ImageOrientationPatient, i).c_str());
    const std::array<double, 3> normal{axes[1] * axes[5] - axes[2] * axes[4],
                                       axes[2] * axes[3] - axes[0] * axes[5],
                                       axes[0] * axes[4] - axes[1] * axes[3]};
    double way = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        way += normal[axis] * (std::atof(slices_.back().position[axis].c_str()) -
                               std::atof(slices_.front().position[axis].c_str()));
    return std::abs(way) / static_cast<double>(slices_.size() - 1);
}

}  // namespace hepatica::dicom_segmentation
