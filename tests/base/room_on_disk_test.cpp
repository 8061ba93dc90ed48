// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/room_on_disk.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cerrno>
#include <csignal>
#include <fstream>
#include <string>
#include <system_error>

#include "core/base/error.h"
#include "core/base/linked_place.h"
#include "core/base/temporary_folder.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

TEST(RoomOnDisk, IsTriedByAFileThatIsGoneAfterwards) {
    const TemporaryFolder folder;
    require_room(folder.path() / "recordings", 100'000);
    EXPECT_TRUE(fs::is_directory(folder.path() / "recordings"));
    EXPECT_TRUE(fs::is_empty(folder.path() / "recordings"));
}

TEST(RoomOnDisk, ThatIsMissingIsToldWithTheFolder) {
    const TemporaryFolder folder;
    // A limit on the size of files makes writes fail half-way, as a full disk does.
    rlimit unlimited{};
    getrlimit(RLIMIT_FSIZE, &unlimited);
    const rlimit tiny{50'000, unlimited.rlim_max};
    const auto handler = signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &tiny);
    std::string place, room;
    try {
        require_room(folder.path(), 100'000);
    } catch (const InputError& error) {
        place = error.place();
    }
    try {
        require_room(folder.path(), 40'000);
    } catch (const InputError& error) {
        room = error.what();
    }
    setrlimit(RLIMIT_FSIZE, &unlimited);
    signal(SIGXFSZ, handler);
    EXPECT_EQ(place, folder.path().string());
    EXPECT_EQ(room, "") << "for less there is some";
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(RoomOnDisk, IsNotWhereAFileIsInTheWay) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "recordings") << "no folder";
    EXPECT_THROW(require_room(folder.path() / "recordings", 1), InputError);
}

TEST(RoomOnDisk, OfAFullOneIsToldInPlainWords) {
    for (const int reason : {ENOSPC, EDQUOT}) try {
            throw_unwritable("/disk/a.txt", std::error_code(reason, std::generic_category()));
        } catch (const InputError& error) {
            EXPECT_EQ(error.problem(), "cannot be written: the disk is full");
            EXPECT_EQ(error.place(), "/disk/a.txt");
        }
}

}  // namespace
}  // namespace hepatica
