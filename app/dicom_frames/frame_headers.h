// SPDX-License-Identifier: GPL-3.0-or-later
// Header values of the frames of an enhanced multi-frame CT (DICOM PS3.3 A.38), converted to those
// of a classic CT slice. They come from the functional groups (C.7.6.16): one shared by all frames,
// and one per frame, which takes precedence.
#pragma once

#include <dcmtk/dcmdata/dctk.h>

#include <vector>

namespace hepatica::dicom_frames {

class FrameHeaders {
  public:
    // Throws Refusal where the number of frames is missing or there is not one group per frame. The
    // data set must outlive it.
    explicit FrameHeaders(DcmDataset& file);

    std::size_t count() const { return frames_.size(); }
    // Throws Refusal where the frames are several stacks or several points in time.
    void require_one_stack() const;
    // The segment number of a frame of a segmentation; throws Refusal where there is none.
    Uint16 segment_of(std::size_t frame) const;
    // Sets position, orientation, spacing, rescale, tilt and pixel format of a frame, counted from
    // 0. What the file does not state is left out.
    void describe(std::size_t frame, DcmDataset& slice) const;

  private:
    // The value of an element of a sequence in the groups as text; "" where it is missing.
    OFString value(std::size_t frame, const DcmTagKey& sequence, const DcmTagKey& element) const;

    DcmDataset& file_;
    DcmItem* shared_ = nullptr;
    std::vector<DcmItem*> frames_;
};

}  // namespace hepatica::dicom_frames
