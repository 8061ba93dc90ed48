// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_editor/draft_slot.h"

#include <string>
#include <utility>

#include "ui/lock_file.h"

namespace hepatica {
namespace {

constexpr int most_slots = 64;

std::filesystem::path slot_file(const std::filesystem::path& first, int number) {
    if (number == 1) return first;
    return first.parent_path() /
           (first.stem().string() + "-" + std::to_string(number) + first.extension().string());
}

}  // namespace

DraftSlot::DraftSlot(const std::filesystem::path& first) {
    if (first.empty()) return;
    std::error_code ignored;
    std::filesystem::create_directories(first.parent_path(), ignored);
    for (const bool left_behind : {true, false})
        for (int number = 1; number <= most_slots; ++number) {
            const std::filesystem::path file = slot_file(first, number);
            if ((!left_behind || std::filesystem::exists(file, ignored)) && take(file)) return;
        }
}

DraftSlot::~DraftSlot() = default;

bool DraftSlot::take(const std::filesystem::path& file) {
    std::unique_ptr<QLockFile> lock = lock_file(file.string() + ".lock");
    if (!lock->tryLock(0)) return false;
    file_ = file;
    lock_ = std::move(lock);
    return true;
}

}  // namespace hepatica
