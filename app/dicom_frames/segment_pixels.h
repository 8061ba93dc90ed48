// SPDX-License-Identifier: GPL-3.0-or-later
// The pixels of one frame of a segmentation (DICOM PS3.3 A.51): one bit or one fraction per pixel
// says whether the frame's segment is there. They become 16-bit labels: the segment's number, or 0.
#pragma once

#include <dcmtk/dcmdata/dcfcache.h>
#include <dcmtk/dcmdata/dctk.h>

#include <cstddef>
#include <vector>

namespace hepatica::dicom_frames {

class SegmentPixels {
  public:
    // Throws Refusal where the segmentation is neither binary nor fractional, is compressed, or has
    // too few pixels. The data set must outlive it.
    SegmentPixels(DcmDataset& file, std::size_t frames);

    // Sets the pixels of the frame and their format. Fractions of at least one half count. Throws
    // Refusal where the pixels cannot be read.
    void copy(std::size_t frame, Uint16 segment, DcmDataset& slice);

  private:
    std::vector<Uint8> bytes_from(std::size_t first, std::size_t end, std::size_t frame);
    bool is_set(const std::vector<Uint8>& bytes, std::size_t pixel, std::size_t first_pixel) const;

    DcmElement* pixels_ = nullptr;
    DcmFileCache cache_;  // keeps the file open between frames
    std::size_t frame_pixels_ = 0;
    std::size_t pixels_per_byte_ = 8;  // 8 if binary, 1 if fractional
    Uint16 whole_ = 1;                 // the value of a fraction of 1
};

}  // namespace hepatica::dicom_frames
