// SPDX-License-Identifier: MIT
#include "base/temporary_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/process_name.h"

namespace strobe {

namespace fs = std::filesystem;

TemporaryFile::TemporaryFile(Path file) : file_(std::move(file)), path_(Path(file_) += "." + processName() + ".part") {}

TemporaryFile::~TemporaryFile() {
  std::error_code ignored;
  fs::remove(path_, ignored);
}

void TemporaryFile::keep() {
  int descriptor = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  bool flushed = descriptor >= 0 && (::fsync(descriptor) == 0 || errno == EINVAL);
  std::error_code reason(errno, std::generic_category());
  if (descriptor >= 0) ::close(descriptor);
  if (flushed) {
    reason.clear();
    fs::rename(path_, file_, reason);
  }
  if (!reason) reason = flushFolder(file_.parent_path());
  if (reason) throw WriteError(fmt::format("cannot be written: {}", reason.message()), {file_.string()});
}

}  // namespace strobe
