// SPDX-License-Identifier: MIT
// Names of processes that are unique among the machines that share a folder.
#pragma once

#include <string>

namespace strobe {

// "HOST.PID" of this process. HOST is the name of the machine without dots, and a hash of its present boot and of the
// process's PID namespace: containers of one machine have equal process numbers.
std::string processName();

// True if `name` is the name of a process of this machine that has ended. Processes of other machines count as running.
bool hasEnded(const std::string& name);

}  // namespace strobe
