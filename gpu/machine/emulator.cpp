// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/machine/emulator.h"

#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>
#include <stdexcept>
#include <utility>
#include <vector>

namespace hepatica::gpu {
namespace {

// Calls visit(i) for every i in [0, count); the shuffled order changes from loop to loop.
class Loops {
  public:
    explicit Loops(BlockOrder order) : order_(order) {}

    template <class Visit>
    void run(int count, const Visit& visit) {
        if (order_ == BlockOrder::shuffled) return shuffled(count, visit);
        for (int i = 0; i < count; ++i) visit(order_ == BlockOrder::ascending ? i : count - 1 - i);
    }

  private:
    // A stride that is coprime to the count reaches every number once.
    template <class Visit>
    void shuffled(int count, const Visit& visit) {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        const auto random = static_cast<long>(state_ >> 33);
        long stride = random % count + 1;
        while (greatest_divisor(stride, count) != 1) ++stride;
        long i = random / 7 % count;
        for (int done = 0; done < count; ++done, i = (i + stride) % count)
            visit(static_cast<int>(i));
    }
    static long greatest_divisor(long a, long b) { return b == 0 ? a : greatest_divisor(b, a % b); }

    BlockOrder order_;
    unsigned long state_ = 1;
};

// Not inlined, so that each kernel is compiled once and not once for each order of blocks and
// threads.
template <class Kernel>
[[gnu::noinline]] void run_thread(const Kernel& kernel, int phase, int block, int thread,
                                  double* shared) {
    kernel(phase, block, thread, shared);
}
template <class Kernel>
[[gnu::noinline]] void end_thread(const Kernel& kernel, int phase, int blocks, int thread,
                                  double* shared) {
    kernel.end(phase, blocks, thread, shared);
}

class Emulator final : public MachineBy<Emulator> {
  public:
    explicit Emulator(BlockOrder order) : loops_(order) {}

    std::string name() const override { return "emulated on the processor"; }

    template <class Kernel>
    void execute(const Kernel& kernel) {
        double shared[Kernel::shared];
        loops_.run(kernel.blocks(), [&](int block) {
            for (int phase = 0; phase < kernel.phases(); ++phase)
                loops_.run(Kernel::threads,
                           [&](int thread) { run_thread(kernel, phase, block, thread, shared); });
        });
        if constexpr (has_end<Kernel>) {
            for (int phase = 0; phase < kernel.end_phases(); ++phase)
                loops_.run(Kernel::threads, [&](int thread) {
                    end_thread(kernel, phase, kernel.blocks(), thread, shared);
                });
        }
    }

  private:
    void* take(std::size_t bytes) override {
        // As a device aligns its memory. Kernels keep numbers that need more than malloc gives.
        constexpr std::size_t alignment = 256;
        if (bytes > std::numeric_limits<std::size_t>::max() - alignment) throw std::bad_alloc();
        const std::size_t whole = (bytes + alignment - 1) / alignment * alignment;
        void* const memory = std::aligned_alloc(alignment, whole);
        if (memory == nullptr) throw std::bad_alloc();
        return std::memset(memory, 0, whole);
    }
    void give_back(void* memory) noexcept override { std::free(memory); }
    void copy_in(void* to, const void* from, std::size_t bytes) override {
        std::memcpy(to, from, bytes);
    }
    void copy_out(void* to, const void* from, std::size_t bytes) override {
        std::memcpy(to, from, bytes);
    }

    void begin_copy_out(void* to, const void* from, std::size_t bytes) override {
        std::memcpy(to, from, bytes);
        under_way_.push_back({to, from, bytes});
    }
    // A device may copy at any time between the two calls, so the source must not have changed.
    void finish_copies() override {
        const std::vector<Copy> copies = std::exchange(under_way_, {});
        for (const Copy& copy : copies)
            if (std::memcmp(copy.to, copy.from, copy.bytes) != 0)
                throw std::logic_error("a kernel wrote to what was being copied");
    }

    struct Copy {
        const void *to, *from;
        std::size_t bytes;
    };
    std::vector<Copy> under_way_;
    Loops loops_;
};

}  // namespace

std::unique_ptr<Machine> make_emulator(BlockOrder order) {
    return std::make_unique<Emulator>(order);
}

}  // namespace hepatica::gpu
