// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/files.h"
#include "base/error.h"

namespace strobe::app {

namespace {

namespace fs = std::filesystem;

// Files of project/ in the shipped folder, and their names in a project.
constexpr std::pair<const char*, const char*> kFiles[] = {{"strobe.project.lua", Home::kProjectFile},
                                                          {"README.md", "README.md"},
                                                          {"gitignore", ".gitignore"},
                                                          {"luarc.json", ".luarc.json"},
                                                          {"passes/smear.lua", "passes/smear.lua"},
                                                          {"shaders/smear.glsl", "shaders/smear.glsl"},
                                                          {"pipelines/smear.lua", "pipelines/smear.lua"}};

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
  for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

void requireName(const std::string& name, const Path& folder) {
  const char* allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  bool good = !name.empty() && name.find_first_not_of(allowed) == std::string::npos && name.front() != '-';
  if (!good)
    throw Error(fmt::format("'{}' is not the name of a project (letters, digits, _ and -)", folder.string()), {}, 2);
}

// Copies a file of project/ in the shipped folder.
void copyTo(const Path& target, const Home& home, const Path& from, const std::string& name) {
  std::string text = readText(home.shipped() / "project" / from);
  replaceAll(text, "PROJECT", name);
  replaceAll(text, "SHIPPED", home.shipped().string());
  writeFileAtomically(target, text);
}

// Copies the files of project/examples with their folders.
void addExamples(const Home& home, const Path& folder, const std::string& name) {
  const Path project = home.shipped() / "project", examples = project / "examples";
  for (const auto& entry : fs::recursive_directory_iterator(examples)) {
    const Path target = folder / fs::relative(entry.path(), examples);
    if (entry.is_directory()) fs::create_directories(target);
    else copyTo(target, home, fs::relative(entry.path(), project), name);
  }
}

void makeProject(const Home& home, const Path& given, bool has_examples) {
  Path folder = fs::absolute(given).lexically_normal();
  if (!folder.has_filename()) folder = folder.parent_path();
  std::string name = folder.filename().string();
  requireName(name, given);
  std::error_code ignored;
  if (fs::exists(folder, ignored) && !fs::is_empty(folder, ignored))
    throw Error(fmt::format("'{}' exists and is not an empty folder", given.string()), {}, 2);
  requireWritable(folder, "new");
  for (const char* part : {"passes", "shaders", "pipelines", "scenes", "experiments", "captures"})
    fs::create_directories(folder / part);
  for (const auto& [from, to] : kFiles) copyTo(folder / to, home, from, name);
  if (has_examples) addExamples(home, folder, name);
  std::printf("%s\nNext: cd %s && strobe render smear -o out/smear.png\n", folder.c_str(), given.c_str());
}

}  // namespace

void registerNew(CLI::App& program, const Home& home) {
  auto folder = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand("new", "Make a project with a pass and a pipeline that run");
  command->add_option("folder", *folder, "folder of the project, new or empty; its name is the name of the project")
      ->required()
      ->type_name("DIR");
  auto has_examples = std::make_shared<bool>(false);
  command->add_flag("--examples", *has_examples,
                    "add an edge detector, a ray, a loop, a family and an extended pipeline");
  command->callback([folder, has_examples, &home] { makeProject(home, *folder, *has_examples); });
}

}  // namespace strobe::app
