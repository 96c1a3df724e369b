// SPDX-License-Identifier: MIT
#include "shader/spirv_cache.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "common/home.h"
#include "common/temporary_folder.h"
#include "shader/compiler.h"

namespace strobe::shader {
namespace spirv_cache_test {

namespace fs = std::filesystem;

constexpr const char* kPreamble = "#version 460\n#extension GL_GOOGLE_include_directive : require\n";

class SpirvCaches : public ::testing::Test {
 protected:
  size_t kept() const {
    std::error_code none;
    return size_t(std::distance(fs::directory_iterator(folder_ / "cache/spirv", none), fs::directory_iterator()));
  }

  Compiled compiled(Output output = Output::Spirv) const {
    const Home cached(home().roots(), {}, home().program(), folder_ / "cache");
    return compile(cached, {kPreamble, folder_ / "main.glsl", ""}, ShaderStage::Compute, output);
  }

  void write(const std::string& name, const std::string& text) const { writeFileAtomically(folder_ / name, text); }

  const testing::TemporaryFolder temporary_;
  const Path folder_ = temporary_.path();
};

TEST_F(SpirvCaches, FindsStoredCodeByKey) {
  const SpirvCache cache(folder_);
  cache.keep("a", {{1, 2, 3}, {4}});
  const std::optional<KeptCode> found = cache.find("a");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->spirv, (std::vector<uint32_t>{1, 2, 3}));
  EXPECT_EQ(found->files, (std::vector<uint32_t>{4}));
  EXPECT_FALSE(cache.find("b"));
}

TEST_F(SpirvCaches, IgnoresDamagedCode) {
  const SpirvCache cache(folder_);
  cache.keep("a", {{1, 2, 3}, {4}});
  const KeptFiles files(folder_ / "spirv");
  const std::string whole = *files.find("a");
  for (size_t size = 0; size < whole.size(); ++size) {
    files.keep("a", whole.substr(0, size));
    EXPECT_FALSE(cache.find("a")) << size << " bytes";
  }
}

TEST_F(SpirvCaches, CompilesOnlyChangedCode) {
  write("main.glsl", "#include \"part.glsl\"\n#if 0\n#include \"other.glsl\"\n#endif\nvoid main() { part(); }\n");
  write("part.glsl", "void part() {}\n");
  write("other.glsl", "this is not compiled\n");
  const Compiled first = compiled(), second = compiled();
  EXPECT_EQ(kept(), 1u);
  EXPECT_EQ(first.spirv, second.spirv);
  EXPECT_EQ(first.files, (std::vector<Path>{folder_ / "main.glsl", folder_ / "part.glsl"}));
  EXPECT_EQ(first.files, second.files);
  EXPECT_EQ(first.spirv, compile(home(), {kPreamble, folder_ / "main.glsl", ""}, ShaderStage::Compute).spirv);

  write("part.glsl", "shared int sum;\nvoid part() { sum = 1; }\n");
  EXPECT_NE(compiled().spirv, first.spirv);
  EXPECT_EQ(kept(), 2u);
  write("part.glsl", "void part() {}\n");
  EXPECT_EQ(compiled().spirv, first.spirv);
  EXPECT_EQ(kept(), 2u);
}

TEST_F(SpirvCaches, CheckIsStoredWithoutCode) {
  write("main.glsl", "void main() {}\n");
  EXPECT_TRUE(compiled(Output::None).spirv.empty());
  EXPECT_EQ(kept(), 1u);
  EXPECT_FALSE(compiled().spirv.empty());
  EXPECT_EQ(kept(), 1u) << "the code replaces the entry of the check";
  EXPECT_EQ(compiled(Output::None).files, std::vector<Path>{folder_ / "main.glsl"});
}

TEST_F(SpirvCaches, MistakesAreReportedEachTime) {
  write("main.glsl", "void main() { nothing_of_that_name(); }\n");
  EXPECT_THROW(compiled(), Error);
  EXPECT_THROW(compiled(), Error);
  EXPECT_EQ(kept(), 0u);
}

}  // namespace spirv_cache_test
}  // namespace strobe::shader
