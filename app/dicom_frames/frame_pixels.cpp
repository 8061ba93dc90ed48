// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dicom_frames/frame_pixels.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <string>

#include "app/dicom_frames/refusal.h"

namespace hepatica::dicom_frames {

namespace {

constexpr std::uint64_t most_bytes =
    std::numeric_limits<Uint32>::max();  // limit of a DICOM element

std::uint64_t number_at(DcmDataset& file, const DcmTagKey& element) {
    Uint16 number = 0;
    file.findAndGetUint16(element, number);
    return number;
}

// The offset table in the first item of compressed pixels: where each frame's first fragment
// begins, counted from the end of that item. Little endian, four bytes each.
std::vector<std::uint64_t> offset_table(DcmPixelItem& item) {
    Uint8* bytes = nullptr;
    std::vector<std::uint64_t> offsets;
    if (item.getLength() == 0 || item.getUint8Array(bytes).bad() || bytes == nullptr)
        return offsets;
    for (std::size_t i = 0; i + 4 <= item.getLength(); i += 4)
        offsets.push_back(bytes[i] | bytes[i + 1] << 8 | bytes[i + 2] << 16 |
                          static_cast<std::uint64_t>(bytes[i + 3]) << 24);
    return offsets;
}

}  // namespace

FramePixels::FramePixels(DcmDataset& file, std::size_t frames) {
    DcmElement* element = nullptr;
    file.findAndGetElement(DCM_PixelData, element);
    pixels_ = dynamic_cast<DcmPixelData*>(element);
    if (pixels_ == nullptr) throw Refusal{"has no pixels (7fe0,0010)"};
    const std::uint64_t rows = number_at(file, DCM_Rows), columns = number_at(file, DCM_Columns);
    const std::uint64_t samples = std::max<std::uint64_t>(1, number_at(file, DCM_SamplesPerPixel));
    bits_ = static_cast<Uint16>(number_at(file, DCM_BitsAllocated));
    const std::string size = std::to_string(columns) + " x " + std::to_string(rows) +
                             " pixels of " + std::to_string(bits_) + " bits";
    if (rows == 0 || columns == 0 || (bits_ != 8 && bits_ != 16) || samples != 1)
        throw Refusal{"has frames of " + size + " and " + std::to_string(samples) + " samples"};
    frame_bytes_ = rows * columns * bits_ / 8;
    const DcmRepresentationParameter* parameter = nullptr;
    pixels_->getOriginalRepresentationKey(syntax_, parameter);
    if (DcmXfer(syntax_).isEncapsulated()) {
        if (pixels_->getEncapsulatedRepresentation(syntax_, parameter, sequence_).bad() ||
            sequence_ == nullptr)
            throw Refusal{"has compressed pixels that cannot be read"};
        find_fragments(frames);
        return;
    }
    if (frame_bytes_ * frames > most_bytes || pixels_->getLength() < frame_bytes_ * frames)
        throw Refusal{"holds " + std::to_string(pixels_->getLength()) + " bytes of pixels, but " +
                      std::to_string(frames) + " frames of " + size + " take " +
                      std::to_string(frame_bytes_ * frames)};
}

void FramePixels::find_fragments(std::size_t frames) {
    for (DcmObject* item = nullptr; (item = sequence_->nextInContainer(item)) != nullptr;)
        if (auto* fragment = dynamic_cast<DcmPixelItem*>(item)) fragments_.push_back(fragment);
    if (fragments_.empty()) throw Refusal{"has compressed pixels without any data"};
    const std::vector<std::uint64_t> offsets = offset_table(*fragments_.front());
    fragments_.erase(fragments_.begin());
    const Refusal unclear{"holds " + std::to_string(frames) + " frames in " +
                          std::to_string(fragments_.size()) +
                          " compressed pieces, and no table that says which are whose"};
    if (fragments_.size() == frames) {
        for (std::size_t i = 0; i <= frames; ++i) first_fragment_.push_back(i);
        return;
    }
    if (offsets.size() != frames) throw unclear;
    constexpr std::uint64_t item_head = 8;  // tag and length before each fragment
    std::uint64_t at = 0;
    for (std::size_t i = 0; i < fragments_.size(); ++i) {
        const std::size_t next = first_fragment_.size();
        if (next < frames && offsets[next] == at) first_fragment_.push_back(i);
        at += item_head + fragments_[i]->getLength();
    }
    if (first_fragment_.size() != frames) throw unclear;
    first_fragment_.push_back(fragments_.size());
}

void FramePixels::copy(std::size_t frame, DcmDataset& slice) {
    if (sequence_ != nullptr)
        copy_fragments(frame, slice);
    else
        copy_plain(frame, slice);
}

void FramePixels::copy_plain(std::size_t frame, DcmDataset& slice) {
    std::vector<Uint16> words((frame_bytes_ + 1) / 2);
    const auto offset = static_cast<Uint32>(frame * frame_bytes_);
    const auto bytes = static_cast<Uint32>(frame_bytes_);
    if (pixels_->getPartialValue(words.data(), offset, bytes, &cache_).bad())
        throw Refusal{"is cut short: the pixels of frame " + std::to_string(frame + 1) +
                      " cannot be read"};
    const OFCondition put =
        bits_ == 8 ? slice.putAndInsertUint8Array(
                         DCM_PixelData, reinterpret_cast<const Uint8*>(words.data()), bytes)
                   : slice.putAndInsertUint16Array(DCM_PixelData, words.data(), words.size());
    if (put.bad()) throw std::bad_alloc();
}

void FramePixels::copy_fragments(std::size_t frame, DcmDataset& slice) {
    const DcmTag pixel_tag(DCM_PixelData, EVR_OB), item_tag(DCM_Item, EVR_OB);
    auto sequence = std::make_unique<DcmPixelSequence>(pixel_tag);
    sequence->insert(new DcmPixelItem(item_tag));  // an empty offset table
    for (std::size_t i = first_fragment_[frame]; i < first_fragment_[frame + 1]; ++i) {
        Uint8* bytes = nullptr;
        const Uint32 length = fragments_[i]->getLength();
        if (fragments_[i]->getUint8Array(bytes).bad() || (bytes == nullptr && length > 0))
            throw Refusal{"is cut short: the pixels of frame " + std::to_string(frame + 1) +
                          " cannot be read"};
        auto item = std::make_unique<DcmPixelItem>(item_tag);
        if (item->putUint8Array(bytes, length).bad()) throw std::bad_alloc();
        sequence->insert(item.release());
        fragments_[i]->compact();  // frees the bytes, which can be read again from the file
    }
    auto pixels = std::make_unique<DcmPixelData>(pixel_tag);
    pixels->putOriginalRepresentation(syntax_, nullptr, sequence.release());
    slice.insert(pixels.release(), OFTrue);
}

}  // namespace hepatica::dicom_frames
