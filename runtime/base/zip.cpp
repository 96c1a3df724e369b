// SPDX-License-Identifier: MIT
#include "base/zip.h"

#include <zip.h>

#include "base/error.h"
#include "base/temporary_file.h"

namespace strobe {

void ZipFile::Close::operator()(zip* opened) const { ::zip_discard(opened); }

void writeZip(const Path& archive, const Path& folder, const std::vector<std::string>& names) {
  std::error_code ignored;
  std::filesystem::create_directories(archive.parent_path(), ignored);
  TemporaryFile written(archive);
  zip* opened = ::zip_open(written.path().c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
  bool good = opened != nullptr;
  for (size_t i = 0; i < names.size() && good; ++i) {
    zip_source_t* source = ::zip_source_file(opened, (folder / names[i]).c_str(), 0, -1);
    const zip_int64_t entry = source ? ::zip_file_add(opened, names[i].c_str(), source, ZIP_FL_ENC_UTF_8) : -1;
    if (entry < 0) ::zip_source_free(source);
    good = entry >= 0 && ::zip_set_file_compression(opened, zip_uint64_t(entry), ZIP_CM_STORE, 0) == 0;
  }
  good = good && ::zip_close(opened) == 0;
  if (good) return written.keep();
  const std::string reason = opened ? ::zip_strerror(opened) : "the folder is not writable";
  if (opened) ::zip_discard(opened);
  throw WriteError("cannot be written: " + reason, {archive.string()});
}

ZipFile::ZipFile(const Path& archive) : archive_(archive) {
  int code = 0;
  opened_.reset(::zip_open(archive.c_str(), ZIP_RDONLY, &code));
  if (opened_) return;
  if (code == ZIP_ER_NOZIP || code == ZIP_ER_INCONS) throw DamagedZip("is not a ZIP archive", {archive.string()});
  throw Error("cannot be opened", {archive.string()});
}

std::vector<std::string> ZipFile::names() const {
  std::vector<std::string> names;
  const zip_int64_t count = ::zip_get_num_entries(opened_.get(), 0);
  for (zip_int64_t i = 0; i < count; ++i)
    if (const char* name = ::zip_get_name(opened_.get(), zip_uint64_t(i), 0)) names.emplace_back(name);
  return names;
}

std::string ZipFile::read(const std::string& name) const {
  zip_stat_t entry{};
  std::error_code unknown;
  const bool found = ::zip_stat(opened_.get(), name.c_str(), 0, &entry) == 0 &&
                     entry.size <= std::filesystem::file_size(archive_, unknown);
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(
      found ? ::zip_fopen(opened_.get(), name.c_str(), 0) : nullptr, &::zip_fclose);
  std::string bytes(file ? entry.size : 0, '\0');
  char beyond = 0;  // the library compares the checksum when it reaches the end of the entry
  const bool is_whole = file && ::zip_fread(file.get(), bytes.data(), bytes.size()) == zip_int64_t(bytes.size()) &&
                        ::zip_fread(file.get(), &beyond, 1) == 0;
  if (!is_whole) throw DamagedZip("has a damaged entry " + name, {archive_.string()});
  return bytes;
}

}  // namespace strobe
