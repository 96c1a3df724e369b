// SPDX-License-Identifier: MIT
#include "base/process_name.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <climits>

#include "base/files.h"
#include "base/hash.h"

namespace strobe {

namespace fs = std::filesystem;

// Content of a file of the system; "" if it is not readable.
static std::string systemText(const Path& file) {
  try {
    return readText(file);
  } catch (const Error&) {
    return "";
  }
}

static std::string hostName() {
  char name[HOST_NAME_MAX + 1] = {};
  ::gethostname(name, sizeof name - 1);
  std::string host = name;
  std::replace_if(
      host.begin(), host.end(), [](unsigned char c) { return !std::isalnum(c); }, '-');
  std::error_code ignored;
  const std::string space = fs::read_symlink("/proc/self/ns/pid", ignored).string();
  return host + "-" + hashText(systemText("/proc/sys/kernel/random/boot_id") + space).substr(0, 4);
}

static const std::string& host() {
  static const std::string name = hostName();
  return name;
}

std::string processName() { return fmt::format("{}.{}", host(), ::getpid()); }

// True for a process that has ended and that its parent has not waited for.
static bool isZombie(const std::string& process) {
  const std::string status = systemText("/proc/" + process + "/stat");
  const size_t name_end = status.rfind(')');
  return name_end != std::string::npos && status.substr(name_end + 1, 2) == " Z";
}

bool hasEnded(const std::string& name) {
  const std::string process = name.substr(name.rfind('.') + 1);
  const bool is_number = !process.empty() && process.size() < 10 &&
                         std::all_of(process.begin(), process.end(), [](unsigned char c) { return std::isdigit(c); });
  if (!is_number || name != host() + "." + process) return false;
  return (::kill(pid_t(std::stol(process)), 0) != 0 && errno == ESRCH) || isZombie(process);
}

}  // namespace strobe
