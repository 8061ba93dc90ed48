// SPDX-License-Identifier: GPL-3.0-or-later
// What an object holds before anyone has written to it, as one figure: options are documented by
// the values that they begin with, and results that nobody filled say 0 or -1, which others rely
// on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <type_traits>

namespace hepatica::test {

// The compiler may not know what the bytes behind a pointer are: it must have written them before,
// and must read them after this.
inline void hide_from_compiler(void* bytes) {
    asm volatile("" : : "r"(bytes) : "memory");
}

// A number below a million that differs where the bytes of `T{}` do. Objects are made in storage of
// two fillings, which shows what they leave unwritten; bytes of 0 count as unwritten, because
// compilers are free to clear padding. Addresses, which differ from run to run, are left out. The
// place of a value counts: a member put before others changes the figure, and that of each struct
// that holds this one before others.
template <class T>
double initial_figure() {
    static_assert(!std::is_polymorphic_v<T>, "its table of functions has an address");
    constexpr std::array<unsigned char, 2> fillings{0xA5, 0x5A};
    alignas(alignof(T) > 8 ? alignof(T) : 8)
        std::array<std::array<unsigned char, (sizeof(T) + 63) / 64 * 64>, 2>
            storage;
    std::array<T*, 2> made{};
    for (std::size_t k = 0; k < 2; ++k) {
        storage[k].fill(fillings[k]);
        hide_from_compiler(storage[k].data());
        made[k] = ::new (static_cast<void*>(storage[k].data())) T{};
        hide_from_compiler(storage[k].data());
    }
    std::uint64_t figure = 0;
    for (std::size_t word = 0; word < sizeof(T); word += 8) {
        std::uint64_t kept = 0;
        bool is_address = false;
        for (std::size_t i = word; i < word + 8 && i < sizeof(T); ++i) {
            const unsigned char a = storage[0][i], b = storage[1][i];
            if (a == fillings[0] && b == fillings[1]) continue;
            is_address = is_address || a != b;
            kept |= static_cast<std::uint64_t>(a) << 8 * (i - word);
        }
        const std::uint64_t top = kept >> 40;
        is_address = is_address || top == 0x55 || top == 0x56 || top == 0x7f;
        if (!is_address && kept != 0)
            figure = (figure + (kept % 999'983 + 1) * (2 * word + 31)) % 999'983;
    }
    for (T* one : made) one->~T();
    return static_cast<double>(figure);
}

}  // namespace hepatica::test

// Adds the figure of a type under its own name.
#define HEPATICA_ADD_INITIAL(figures, Type) \
    (figures).add(#Type, ::hepatica::test::initial_figure<Type>())
