// SPDX-License-Identifier: GPL-3.0-or-later
// What a segmentation says of the CT slices that it was drawn on: where each lies, and by which
// identifiers it refers to it.
#pragma once

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace hepatica::dicom_segmentation {

struct SourceSlice {
    OFString sop_class, sop_instance;
    std::array<OFString, 3> position;  // centre of the first pixel, LPS mm
};

// A decimal string of at most 16 characters, as the standard wants; some scanners write longer
// ones.
OFString decimal(double value);

class SourceSlices {
  public:
    // The header of each file, without pixels. Throws Refusal where one cannot be read or does not
    // say what every CT slice says.
    explicit SourceSlices(const std::vector<std::string>& files);

    const std::vector<SourceSlice>& all() const { return slices_; }
    DcmDataset& first() { return *first_.getDataset(); }
    // Of the first slice; "" where it does not stand there.
    OFString text(const DcmTagKey& element, unsigned long index = 0) const;
    // The same of a number, in 16 characters.
    OFString number(const DcmTagKey& element, unsigned long index = 0) const;
    Uint16 rows() const { return rows_; }
    Uint16 columns() const { return columns_; }
    // Between the first and the last slice along their normal, over the steps between [mm].
    double spacing_mm() const;

  private:
    mutable DcmFileFormat first_;  // DCMTK's look-ups are not const
    std::vector<SourceSlice> slices_;
    Uint16 rows_ = 0, columns_ = 0;
};

}  // namespace hepatica::dicom_segmentation
