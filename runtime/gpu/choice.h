// SPDX-License-Identifier: MIT
// Choice of one Vulkan device among several.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gpu/device.h"

namespace strobe::gpu {

// Text of the option `--device`.
inline constexpr const char* kDeviceHelp =
    "index, part of the name, UUID or PCI address of a Vulkan device (default: in a Slurm job, the job's GPU)";

// UUID and PCI address as in `DeviceInfo`.
std::string uuidText(const uint8_t (&bytes)[16]);
std::string pciText(uint32_t domain, uint32_t bus, uint32_t device, uint32_t function);

// Value of CUDA_VISIBLE_DEVICES in a Slurm job; empty outside of Slurm or without the variable. Vulkan ignores the
// variable.
std::optional<std::string> gpusOfJob();

// Index in `devices` (best first) of the device that `wanted` names. For "": the first GPU of the job, which is a UUID
// or an index in the order of PCI addresses; a software device if the job has no GPU; otherwise the first device.
// Throws `Error` (exit code 2) if no device matches.
size_t chosenDevice(const std::vector<DeviceInfo>& devices, const std::string& wanted,
                    const std::optional<std::string>& of_job);

}  // namespace strobe::gpu
