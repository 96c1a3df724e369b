// SPDX-License-Identifier: MIT
// ZIP archives without compression.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/files.h"

struct zip;  // of libzip

namespace strobe {

// Packs the files `folder`/NAME into a new archive, with the entries NAME. The archive gets its name when it is
// complete and flushed to disk. Throws `WriteError`.
void writeZip(const Path& archive, const Path& folder, const std::vector<std::string>& names);

// The file is not a ZIP archive, or its directory or an entry differs from its checksum.
struct DamagedZip : Error {
  using Error::Error;
};

// Archive that is open for reading. The functions throw `DamagedZip`, or `Error` if the file cannot be opened.
class ZipFile {
 public:
  explicit ZipFile(const Path& archive);

  std::vector<std::string> names() const;
  std::string read(const std::string& name) const;

 private:
  struct Close {
    void operator()(zip* opened) const;
  };

  Path archive_;
  std::unique_ptr<zip, Close> opened_;
};

}  // namespace strobe
