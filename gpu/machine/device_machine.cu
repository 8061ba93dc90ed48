// SPDX-License-Identifier: GPL-3.0-or-later
#include <cuda_runtime.h>

#include "core/base/error.h"
#include "gpu/machine/device_error.h"
#include "gpu/machine/device_machine.h"

namespace hepatica::gpu {
namespace {

void require(cudaError_t status, const char* what) {
    if (status == cudaSuccess) return;
    throw DeviceError(std::string(what) + ": " + cudaGetErrorString(status));
}

template <class Kernel>
__global__ void __launch_bounds__(Kernel::threads) run_phases(const Kernel kernel) {
    __shared__ double shared[Kernel::shared];
    for (int phase = 0; phase < kernel.phases(); ++phase) {
        if (phase > 0) __syncthreads();
        kernel(phase, static_cast<int>(blockIdx.x), static_cast<int>(threadIdx.x), shared);
    }
}

class DeviceMachine final : public MachineBy<DeviceMachine> {
  public:
    std::string name() const override { return device_info().device; }

    template <class Kernel>
    void execute(const Kernel& kernel) {
        run_phases<<<kernel.blocks(), Kernel::threads>>>(kernel);
        require(cudaGetLastError(), "a kernel could not be launched");
    }

    void pin(void* memory, std::size_t bytes) override {
        if (cudaHostRegister(memory, bytes, cudaHostRegisterDefault) != cudaSuccess)
            cudaGetLastError();  // forgotten: pinning is for speed alone
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
    } else {
        cudaDeviceProp properties{};
        require(cudaGetDeviceProperties(&properties, 0), "the device does not answer");
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
