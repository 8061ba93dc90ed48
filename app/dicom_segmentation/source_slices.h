// SPDX-License-Identifier: GPL-3.0-or-later
// The CT slices to which a segmentation refers: their positions and identifiers.
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
    std::array<OFString, 3> position;  // centre of the first pixel [mm, LPS]
};

// A decimal string of at most 16 characters, as the standard requires; some scanners write longer
// ones.
OFString decimal(double value);

class SourceSlices {
  public:
    // Reads the header of each file, without pixels. Throws Refusal where one cannot be read or
    // lacks required values.
    explicit SourceSlices(const std::vector<std::string>& files);

    const std::vector<SourceSlice>& all() const { return slices_; }
    DcmDataset& first() { return *first_.getDataset(); }
    // A value of the first slice as text; "" where it is missing.
    OFString text(const DcmTagKey& element, unsigned long index = 0) const;
    // The same for a number, as a decimal string.
    OFString number(const DcmTagKey& element, unsigned long index = 0) const;
    Uint16 rows() const { return rows_; }
    Uint16 columns() const { return columns_; }
    // Mean spacing [mm]: the distance between the first and the last slice along their normal,
    // divided by the number of steps; of a single slice its thickness. Throws Refusal where that is
    // missing.
    double spacing_mm() const;

  private:
    mutable DcmFileFormat first_;  // DCMTK's look-ups are not const
    std::vector<SourceSlice> slices_;
    Uint16 rows_ = 0, columns_ = 0;
};

}  // namespace hepatica::dicom_segmentation
