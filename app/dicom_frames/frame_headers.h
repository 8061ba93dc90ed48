// SPDX-License-Identifier: GPL-3.0-or-later
// What an enhanced multi-frame CT (DICOM PS3.3 A.38) says of its frames, in the words of a classic
// CT slice. The functional groups (C.7.6.16) hold it: one shared by all frames, and one of each
// frame, which goes first.
#pragma once

#include <dcmtk/dcmdata/dctk.h>

#include <vector>

namespace hepatica::dicom_frames {

class FrameHeaders {
  public:
    // Throws Refusal where the number of frames is none or the groups are not one of each frame.
    // The data set must outlive it.
    explicit FrameHeaders(DcmDataset& file);

    std::size_t count() const { return frames_.size(); }
    // Throws Refusal where the frames are several stacks or several points in time.
    void require_one_stack() const;
    // The segment that a frame of a segmentation shows; throws Refusal where none is named.
    Uint16 segment_of(std::size_t frame) const;
    // Sets position, orientation, spacing, rescale, tilt and the format of the pixels of a frame
    // counted from 0. What the file does not state is left out.
    void describe(std::size_t frame, DcmDataset& slice) const;

  private:
    // The value of an element of a sequence of the groups as text; "" where it is missing.
    OFString value(std::size_t frame, const DcmTagKey& sequence, const DcmTagKey& element) const;

    DcmDataset& file_;
    DcmItem* shared_ = nullptr;
    std::vector<DcmItem*> frames_;
};

}  // namespace hepatica::dicom_frames
