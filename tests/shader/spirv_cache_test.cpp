// SPDX-License-Identifier: MIT
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

  std::vector<uint32_t> compiled(Output output = Output::Spirv) const {
    const Home cached(home().roots(), {}, home().program(), folder_ / "cache");
    return compile(cached, {kPreamble, folder_ / "main.glsl", ""}, ShaderStage::Compute, output);
  }

  void write(const std::string& name, const std::string& text) const { writeFileAtomically(folder_ / name, text); }

  const testing::TemporaryFolder temporary_;
  const Path folder_ = temporary_.path();
};

TEST_F(SpirvCaches, CompilesOnlyChangedCode) {
  write("main.glsl", "#include \"part.glsl\"\n#if 0\n#include \"other.glsl\"\n#endif\nvoid main() { part(); }\n");
  write("part.glsl", "void part() {}\n");
  write("other.glsl", "this is not compiled\n");
  const std::vector<uint32_t> first = compiled(), second = compiled();
  EXPECT_EQ(kept(), 1u);
  EXPECT_EQ(first, second);
  EXPECT_EQ(first, compile(home(), {kPreamble, folder_ / "main.glsl", ""}, ShaderStage::Compute));

  write("part.glsl", "shared int sum;\nvoid part() { sum = 1; }\n");
  EXPECT_NE(compiled(), first);
  EXPECT_EQ(kept(), 2u);
  write("part.glsl", "void part() {}\n");
  EXPECT_EQ(compiled(), first);
  EXPECT_EQ(kept(), 2u);
}

TEST_F(SpirvCaches, CheckIsStoredWithoutCode) {
  write("main.glsl", "void main() {}\n");
  EXPECT_TRUE(compiled(Output::None).empty());
  EXPECT_EQ(kept(), 1u);
  EXPECT_FALSE(compiled().empty());
  EXPECT_EQ(kept(), 1u) << "the code replaces the entry of the check";
}

TEST_F(SpirvCaches, MistakesAreReportedEachTime) {
  write("main.glsl", "void main() { nothing_of_that_name(); }\n");
  EXPECT_THROW(compiled(), Error);
  EXPECT_THROW(compiled(), Error);
  EXPECT_EQ(kept(), 0u);
}

}  // namespace spirv_cache_test
}  // namespace strobe::shader
