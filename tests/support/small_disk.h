// SPDX-License-Identifier: GPL-3.0-or-later
// A disk that is full, for writers: a limit on the size of files makes their writes fail half-way.
#pragma once

#include <sys/resource.h>

#include <csignal>
#include <cstdint>

namespace hepatica::test {

// Files of this process and its children take so many bytes while it lives.
class DiskOf {
  public:
    explicit DiskOf(std::uintmax_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit small{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
    }
    ~DiskOf() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    DiskOf(const DiskOf&) = delete;
    DiskOf& operator=(const DiskOf&) = delete;

  private:
    rlimit before_{};
    void (*handler_)(int);
};

}  // namespace hepatica::test
