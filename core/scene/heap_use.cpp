// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/heap_use.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace hepatica {

std::size_t heap_bytes_in_use() {
#ifdef __GLIBC__
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
#else
    return 0;
#endif
}

}  // namespace hepatica
