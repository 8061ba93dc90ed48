// SPDX-License-Identifier: GPL-3.0-or-later
// The pixels of one frame of a segmentation (DICOM PS3.3 A.51): where the frame's segment is, a bit
// or a fraction a pixel. They become 16-bit labels: the number of the segment, or 0.
#pragma once

#include <dcmtk/dcmdata/dcfcache.h>
#include <dcmtk/dcmdata/dctk.h>

#include <cstddef>
#include <vector>

namespace hepatica::dicom_frames {

class SegmentPixels {
  public:
    // Throws Refusal where it is neither binary nor fractional, compressed, or has too few pixels.
    // The data set must outlive it.
    SegmentPixels(DcmDataset& file, std::size_t frames);

    // Sets the pixels of the frame and their format. A fraction counts from one half on. Throws
    // Refusal where they cannot be read.
    void copy(std::size_t frame, Uint16 segment, DcmDataset& slice);

  private:
    std::vector<Uint8> bytes_from(std::size_t first, std::size_t end, std::size_t frame);
    bool is_set(const std::vector<Uint8>& bytes, std::size_t pixel, std::size_t first_pixel) const;

    DcmElement* pixels_ = nullptr;
    DcmFileCache cache_;  // keeps the file open from frame to frame
    std::size_t frame_pixels_ = 0;
    std::size_t pixels_per_byte_ = 8;  // 8 where it is binary, 1 where it is fractional
    Uint16 whole_ = 1;                 // what stands for a fraction of 1
};

}  // namespace hepatica::dicom_frames
