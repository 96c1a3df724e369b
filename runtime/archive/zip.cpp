// SPDX-License-Identifier: MIT
#include "archive/zip.h"

#include <sys/stat.h>
#include <zip.h>

#include <filesystem>
#include <memory>
#include <set>
#include <sstream>

#include "archive/crate.h"
#include "archive/manifest.h"
#include "base/temporary_file.h"

namespace strobe::archive {

namespace fs = std::filesystem;

namespace {

constexpr zip_uint16_t kFirstDay = 1 << 5 | 1;  // 1980-01-01: years since 1980, month, day
constexpr zip_uint32_t kPlainFile = zip_uint32_t{S_IFREG | 0644} << 16;

// Names in lines of the form "SHA-256, two spaces, name".
std::set<std::string> listedIn(const Path& folder) {
  std::set<std::string> names = {kSumsFile, kCrateFile};
  std::istringstream lines(readText(folder / kSumsFile));
  for (std::string line; std::getline(lines, line);)
    if (line.size() > 66) names.insert(line.substr(66));
  return names;
}

class Zip {
 public:
  // `shown`: file name in errors.
  Zip(const Path& file, const Path& shown) : shown_(shown) {
    int code = 0;
    zip_.reset(::zip_open(file.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code));
    if (zip_) return;
    zip_error_t error;
    ::zip_error_init_with_code(&error, code);
    std::string reason = ::zip_error_strerror(&error);
    ::zip_error_fini(&error);
    fail(reason);
  }

  // The file is read when the zip is closed.
  void add(const Path& file, const std::string& name) {
    if (!fs::is_regular_file(file)) throw Error("is listed, but is missing", {file.string()});
    zip_source_t* source = ::zip_source_file(zip_.get(), file.c_str(), 0, -1);
    zip_int64_t added = source ? ::zip_file_add(zip_.get(), name.c_str(), source, ZIP_FL_ENC_UTF_8) : -1;
    if (source && added < 0) ::zip_source_free(source);
    auto entry = static_cast<zip_uint64_t>(added);
    if (added < 0 || ::zip_set_file_compression(zip_.get(), entry, ZIP_CM_DEFLATE, 0) != 0 ||
        ::zip_file_set_dostime(zip_.get(), entry, 0, kFirstDay, 0) != 0 ||
        ::zip_file_set_external_attributes(zip_.get(), entry, 0, ZIP_OPSYS_UNIX, kPlainFile) != 0)
      fail(::zip_strerror(zip_.get()));
  }

  void close() {
    if (::zip_close(zip_.get()) != 0) fail(::zip_strerror(zip_.get()));
    static_cast<void>(zip_.release());
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw WriteError("cannot be written: " + reason, {shown_.string()});
  }

  struct Discard {
    void operator()(zip_t* zip) const { ::zip_discard(zip); }
  };
  const Path& shown_;
  std::unique_ptr<zip_t, Discard> zip_;
};

}  // namespace

Path zipBeside(const Path& folder) {
  Path path = fs::absolute(folder).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  return path += ".zip";
}

void writeZip(const Path& folder, const Path& zip) {
  TemporaryFile temporary(zip);
  Zip archive(temporary.path(), zip);
  for (const std::string& name : listedIn(folder)) archive.add(folder / name, name);
  archive.close();
  temporary.keep();
}

}  // namespace strobe::archive
