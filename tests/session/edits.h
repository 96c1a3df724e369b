// SPDX-License-Identifier: MIT
// Random mistakes in the files of a session, like typing errors; reproducible by a seed.
#pragma once

#include <random>

#include "session/home.h"

namespace strobe::session {

struct Edit {
  std::string kind;  // "syntax", "truncated", "renamed", "binding", "deleted", "nonsense", "endless", "comment"
  std::string file;
  std::string text;  // new text of the file; unused for "deleted"
  Save save = Save::InPlace;
  std::string shown() const { return kind + " in " + file; }
};

// A mistake (or a harmless comment) in one of `files`, which maps names to good texts.
Edit randomEdit(std::mt19937& random, const std::map<std::string, std::string>& files);

}  // namespace strobe::session
