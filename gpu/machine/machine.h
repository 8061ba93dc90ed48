// SPDX-License-Identifier: GPL-3.0-or-later
// A machine runs kernels and holds their arrays: a CUDA device, or the emulator on the host. It
// counts the costs. Kernels of one machine run one after another. Not thread-safe.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <type_traits>

#include "gpu/kernels/kernel.h"
#include "gpu/kernels/kernel_list.h"

namespace hepatica::gpu {

// Costs since the machine was made. Barriers are those between phases of a kernel; the end of a
// kernel is none.
struct Traffic {
    long launches = 0;
    long barriers = 0;
    std::size_t kernel_bytes = 0;  // see bytes_of
    long copies = 0;               // to and from the device
    std::size_t copied_bytes = 0;
};

namespace detail {

template <class Kernel, class... List>
constexpr std::size_t position_in(KernelList<List...>) {
    std::size_t position = 0;
    static_cast<void>(((std::is_same_v<Kernel, List> || (++position, false)) || ...));
    return position;
}
template <class... List>
constexpr std::size_t size_of(KernelList<List...>) {
    return sizeof...(List);
}

}  // namespace detail

// Functions that allocate, copy or launch throw DeviceError where the device fails.
class Machine {
  public:
    virtual ~Machine() = default;

    virtual std::string name() const = 0;

    // Allocates zero-initialised memory.
    void* allocate(std::size_t bytes) {
        void* const memory = take(bytes);
        held_bytes_ += bytes;
        return memory;
    }
    void release(void* memory, std::size_t bytes) {
        held_bytes_ -= bytes;
        give_back(memory);
    }
    // Page-locks host memory that is often copied, which makes copies several times faster. Unpin
    // it before freeing it. Where pinning fails, copies are merely slower.
    virtual void pin(void*, std::size_t) {}
    virtual void unpin(void*) noexcept {}
    // Both wait until the machine has finished everything launched before.
    void upload(void* to, const void* from, std::size_t bytes) {
        count_copy(bytes);
        copy_in(to, from, bytes);
    }
    void download(void* to, const void* from, std::size_t bytes) {
        count_copy(bytes);
        copy_out(to, from, bytes);
    }
    // Starts an asynchronous copy of the results of everything launched before. Kernels launched
    // afterwards must not write to the source. The data are complete once finish_downloads() has
    // returned.
    void begin_download(void* to, const void* from, std::size_t bytes) {
        count_copy(bytes);
        begin_copy_out(to, from, bytes);
    }
    void finish_downloads() { finish_copies(); }

    // Kernels without blocks do nothing.
    template <class Kernel>
    void launch(const Kernel& kernel) {
        constexpr std::size_t position = detail::position_in<Kernel>(AllKernels());
        static_assert(position < detail::size_of(AllKernels()), "a kernel that is in no list");
        if (kernel.blocks() == 0) return;
        ++traffic_.launches;
        traffic_.barriers += kernel.phases() - 1;
        if constexpr (has_end<Kernel>) traffic_.barriers += kernel.end_phases();
        traffic_.kernel_bytes += kernel.bytes();
        run(position, &kernel);
    }
    template <class Item>
    void for_each(const Item& item) {
        launch(ForEach<Item>{item});
    }

    const Traffic& traffic() const { return traffic_; }
    std::size_t held_bytes() const { return held_bytes_; }

  private:
    // Runs the kernel of that position in AllKernels.
    virtual void run(std::size_t position, const void* kernel) = 0;
    virtual void* take(std::size_t bytes) = 0;
    virtual void give_back(void* memory) noexcept = 0;
    virtual void copy_in(void* to, const void* from, std::size_t bytes) = 0;
    virtual void copy_out(void* to, const void* from, std::size_t bytes) = 0;
    virtual void begin_copy_out(void* to, const void* from, std::size_t bytes) = 0;
    virtual void finish_copies() = 0;

    void count_copy(std::size_t bytes) {
        ++traffic_.copies;
        traffic_.copied_bytes += bytes;
    }

    Traffic traffic_;
    std::size_t held_bytes_ = 0;
};

// A machine whose member template execute(kernel) runs any kernel. One table of functions, and not
// a virtual function per kernel: the compiler takes minutes to find their overriders.
template <class Self>
class MachineBy : public Machine {
  private:
    void run(std::size_t position, const void* kernel) final {
        static constexpr auto executions = executions_of(AllKernels());
        executions[position](static_cast<Self&>(*this), kernel);
    }

    using Execution = void (*)(Self&, const void*);
    template <class... Kernel>
    static constexpr std::array<Execution, sizeof...(Kernel)> executions_of(KernelList<Kernel...>) {
        return {[](Self& machine, const void* kernel) {
            machine.execute(*static_cast<const Kernel*>(kernel));
        }...};
    }
};

}  // namespace hepatica::gpu
