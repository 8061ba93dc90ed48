// SPDX-License-Identifier: GPL-3.0-or-later
// The pixels of one of many frames (DICOM PS3.5 A.4): a range of uncompressed pixels, or the
// fragments of a compressed stream that belong to the frame, which stay compressed.
#pragma once

#include <dcmtk/dcmdata/dcfcache.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dctk.h>

#include <cstddef>
#include <vector>

namespace hepatica::dicom_frames {

class FramePixels {
  public:
    // Throws Refusal where the pixels are missing, fewer than the header states, or compressed in
    // fragments that cannot be assigned to frames. The data set must outlive it.
    FramePixels(DcmDataset& file, std::size_t frames);

    // The transfer syntax in which a slice must be stored.
    E_TransferSyntax syntax() const {
        return sequence_ != nullptr ? syntax_ : EXS_LittleEndianExplicit;
    }
    // Copies the pixels of a frame, counted from 0. Throws Refusal where they cannot be read.
    void copy(std::size_t frame, DcmDataset& slice);

  private:
    void find_fragments(std::size_t frames);
    void copy_plain(std::size_t frame, DcmDataset& slice);
    void copy_fragments(std::size_t frame, DcmDataset& slice);

    DcmPixelData* pixels_ = nullptr;
    DcmFileCache cache_;  // keeps the file open between frames
    std::size_t frame_bytes_ = 0;
    Uint16 bits_ = 0;
    E_TransferSyntax syntax_ = EXS_Unknown;
    DcmPixelSequence* sequence_ = nullptr;  // only for compressed pixels
    std::vector<DcmPixelItem*> fragments_;
    std::vector<std::size_t> first_fragment_;  // of each frame, and the end
};

}  // namespace hepatica::dicom_frames
