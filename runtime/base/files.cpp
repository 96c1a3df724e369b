// SPDX-License-Identifier: MIT
#include "base/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "base/process_name.h"

namespace strobe {

namespace fs = std::filesystem;

std::string readText(const Path& file) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) throw Error("is a folder, not a file", {file.string()});
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error(fmt::format("cannot be read: {}", std::strerror(errno)), {file.string()});
  std::ostringstream text;
  text << stream.rdbuf();
  if (stream.bad()) throw Error("reading failed", {file.string()});
  return std::move(text).str();
}

std::vector<uint8_t> readBytes(const Path& file) {
  std::string text = readText(file);
  return {text.begin(), text.end()};
}

static void writeAll(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw std::system_error(errno, std::generic_category());
    bytes.remove_prefix(static_cast<size_t>(written));
  }
}

// Ignores EINVAL (the file system does not flush folders) and EACCES (the folder is writable, but not readable).
std::error_code flushFolder(const Path& folder) {
  int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  bool failed = descriptor < 0 || ::fsync(descriptor) != 0;
  int reason = failed && errno != EINVAL && errno != EACCES ? errno : 0;
  if (descriptor >= 0) ::close(descriptor);
  return {reason, std::generic_category()};
}

void writeFileAtomically(const Path& file, std::string_view bytes, Flush flush) {
  Path temporary = file;
  temporary += "." + processName() + ".part";
  int descriptor = -1;
  try {
    if (file.has_parent_path()) fs::create_directories(file.parent_path());
    descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (descriptor < 0) throw std::system_error(errno, std::generic_category());
    writeAll(descriptor, bytes);
    bool failed = flush == Flush::yes && ::fsync(descriptor) != 0 && errno != EINVAL;
    if (failed) throw std::system_error(errno, std::generic_category());
    if (::close(std::exchange(descriptor, -1)) != 0) throw std::system_error(errno, std::generic_category());
    fs::rename(temporary, file);
    std::error_code unflushed = flush == Flush::yes ? flushFolder(file.parent_path()) : std::error_code();
    if (unflushed) throw std::system_error(unflushed);
  } catch (const std::system_error& error) {
    if (descriptor >= 0) ::close(descriptor);
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw WriteError(fmt::format("cannot be written: {}", error.code().message()), {file.string()});
  }
}

void writeFileAtomically(const Path& file, const std::vector<uint8_t>& bytes) {
  writeFileAtomically(file, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

bool hasExtension(std::string_view name, std::string_view extension) {
  if (name.size() < extension.size()) return false;
  auto same = [](char a, char b) { return std::tolower(uint8_t(a)) == std::tolower(uint8_t(b)); };
  return std::equal(extension.begin(), extension.end(), name.end() - std::ptrdiff_t(extension.size()), same);
}

std::vector<std::string> namesIn(const Path& folder, std::string_view extension) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == extension) names.push_back(entry.path().stem());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace strobe
