// SPDX-License-Identifier: GPL-3.0-or-later
#include <cuda_runtime.h>

#include <cuda/atomic>

#include "core/base/error.h"
#include "gpu/machine/device_error.h"
#include "gpu/machine/device_machine.h"

namespace hepatica::gpu {
namespace {

void require(cudaError_t status, const char* what) {
    if (status == cudaSuccess) return;
    throw DeviceError(std::string(what) + ": " + cudaGetErrorString(status));
}

// Threads that every supported multiprocessor can hold.
#if defined(__CUDA_ARCH__) && __CUDA_ARCH__ < 800
constexpr int held_threads = 1024;
#else
constexpr int held_threads = 1536;
#endif
template <class Kernel>
constexpr int asked_blocks =
    least_blocks<Kernel>* Kernel::threads <= held_threads ? least_blocks<Kernel>
                                                          : held_threads / Kernel::threads;

// On compute capability 9.0 and later a kernel may be launched while the one before still runs; it
// waits here until everything written by that one is visible.
__device__ void wait_for_the_kernel_before() {
#if __CUDA_ARCH__ >= 900
    cudaTriggerProgrammaticLaunchCompletion();
    cudaGridDependencySynchronize();
#endif
}

// True in the block that ends last, which then sees what all blocks wrote. `ended` is zero before
// the first block ends and after the last. One thread releases its block's writes, and only the
// last block acquires: a fence in every thread would flush the multiprocessor's cache once per
// warp.
__device__ bool is_last_block(unsigned* ended) {
    __shared__ bool last;
    __syncthreads();
    if (threadIdx.x == 0) {
        cuda::atomic_ref<unsigned, cuda::thread_scope_device> blocks(*ended);
        last = blocks.fetch_add(1u, cuda::memory_order_release) + 1 == gridDim.x;
        if (last) {
            cuda::atomic_thread_fence(cuda::memory_order_acquire, cuda::thread_scope_device);
            *ended = 0;
        }
    }
    __syncthreads();
    return last;
}

template <class Kernel>
__global__ void __launch_bounds__(Kernel::threads, asked_blocks<Kernel>)
    run_phases(const Kernel kernel, unsigned* ended) {
    __shared__ double shared[Kernel::shared];
    const int block = static_cast<int>(blockIdx.x), thread = static_cast<int>(threadIdx.x);
    wait_for_the_kernel_before();
    for (int phase = 0; phase < kernel.phases(); ++phase) {
        if (phase > 0) __syncthreads();
        kernel(phase, block, thread, shared);
    }
    if constexpr (has_end<Kernel>) {
        if (!is_last_block(ended)) return;
        for (int phase = 0; phase < kernel.end_phases(); ++phase) {
            if (phase > 0) __syncthreads();
            kernel.end(phase, static_cast<int>(gridDim.x), thread, shared);
        }
    }
}

// Whether a kernel can be launched while the one before it still runs.
bool launches_overlap() {
    int major = 0;
    require(cudaDeviceGetAttribute(&major, cudaDevAttrComputeCapabilityMajor, 0),
            "the device does not answer");
    return major >= 9;
}

class DeviceMachine final : public MachineBy<DeviceMachine> {
  public:
    DeviceMachine() : overlap_(launches_overlap()) {
        require(cudaMalloc(&ended_, sizeof *ended_), "no memory on the device");
        require(cudaMemset(ended_, 0, sizeof *ended_), "the device failed");
        require(cudaStreamCreateWithFlags(&copies_, cudaStreamNonBlocking), "the device failed");
        require(cudaEventCreateWithFlags(&written_, cudaEventDisableTiming), "the device failed");
    }
    ~DeviceMachine() override {
        cudaEventDestroy(written_);
        cudaStreamDestroy(copies_);
        cudaFree(ended_);
    }
    DeviceMachine(const DeviceMachine&) = delete;
    DeviceMachine& operator=(const DeviceMachine&) = delete;

    std::string name() const override { return device_info().device; }

    template <class Kernel>
    void execute(const Kernel& kernel) {
        cudaLaunchAttribute overlap{};
        overlap.id = cudaLaunchAttributeProgrammaticStreamSerialization;
        overlap.val.programmaticStreamSerializationAllowed = 1;
        cudaLaunchConfig_t config{};
        config.gridDim = dim3(static_cast<unsigned>(kernel.blocks()));
        config.blockDim = dim3(Kernel::threads);
        config.attrs = &overlap;
        config.numAttrs = overlap_ ? 1 : 0;
        require(cudaLaunchKernelEx(&config, run_phases<Kernel>, kernel, ended_),
                "a kernel could not be launched");
    }

    void pin(void* memory, std::size_t bytes) override {
        if (cudaHostRegister(memory, bytes, cudaHostRegisterDefault) != cudaSuccess)
            cudaGetLastError();  // clears the error: pinning is only an optimisation
    }
    void unpin(void* memory) noexcept override {
        if (cudaHostUnregister(memory) != cudaSuccess) cudaGetLastError();
    }

  private:
    void* take(std::size_t bytes) override {
        void* memory = nullptr;
        require(cudaMalloc(&memory, bytes), "no memory on the device");
        require(cudaMemset(memory, 0, bytes), "the device failed");
        return memory;
    }
    void give_back(void* memory) noexcept override { cudaFree(memory); }
    void copy_in(void* to, const void* from, std::size_t bytes) override {
        require(cudaMemcpy(to, from, bytes, cudaMemcpyHostToDevice), "a copy to the device failed");
    }
    void copy_out(void* to, const void* from, std::size_t bytes) override {
        require(cudaMemcpy(to, from, bytes, cudaMemcpyDeviceToHost),
                "a copy from the device failed");
    }
    void begin_copy_out(void* to, const void* from, std::size_t bytes) override {
        require(cudaEventRecord(written_), "the device failed");
        require(cudaStreamWaitEvent(copies_, written_), "the device failed");
        require(cudaMemcpyAsync(to, from, bytes, cudaMemcpyDeviceToHost, copies_),
                "a copy from the device failed");
    }
    void finish_copies() override {
        require(cudaStreamSynchronize(copies_), "a copy from the device failed");
    }

    bool overlap_;
    unsigned* ended_ = nullptr;  // blocks of the running kernel that have ended
    cudaStream_t copies_ = nullptr;
    cudaEvent_t written_ = nullptr;  // marks everything launched before a copy
};

std::string version_text(int version) {
    return std::to_string(version / 1000) + "." + std::to_string(version % 1000 / 10);
}

DeviceInfo look() {
    DeviceInfo info;
    info.compiled = true;
    info.architectures = HEPATICA_CUDA_ARCHITECTURES;
    int driver = 0, runtime = 0, devices = 0;
    cudaDriverGetVersion(&driver);
    cudaRuntimeGetVersion(&runtime);
    if (driver == 0) {
        info.reason = "this computer has no NVIDIA driver";
        return info;
    }
    info.driver = version_text(driver);
    const cudaError_t found = cudaGetDeviceCount(&devices);
    if (found == cudaErrorInsufficientDriver) {
        info.reason = "the driver knows CUDA " + info.driver + ", which is older than the " +
                      version_text(runtime) + " of this build";
    } else if (found != cudaSuccess || devices == 0) {
        info.reason = "this computer has no CUDA device that can be used";
    } else if (cudaDeviceProp properties{};
               cudaGetDeviceProperties(&properties, 0) != cudaSuccess) {
        cudaGetLastError();  // clears it
        info.reason = "the CUDA device does not answer";
    } else {
        info.device = properties.name;
        info.memory_bytes = properties.totalGlobalMem;
    }
    return info;
}

}  // namespace

DeviceInfo device_info() {
    static const DeviceInfo info = look();
    return info;
}

std::unique_ptr<Machine> make_device_machine() {
    const DeviceInfo info = device_info();
    if (!info.reason.empty())
        throw InputError(info.reason, "the CUDA back end",
                         "Use the processor, or a computer with an NVIDIA device");
    return std::make_unique<DeviceMachine>();
}

}  // namespace hepatica::gpu
