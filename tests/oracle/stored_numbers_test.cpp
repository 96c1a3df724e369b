// SPDX-License-Identifier: MIT
// Runs the functions of mixin/quantised.glsl on chosen numbers, against the definitions of half floats and depth
// encodings: the list of all half floats, and 1 - n/z in double precision.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <random>

#include "common/temporary_folder.h"
#include "gpu/pipeline.h"
#include "oracle/render.h"
#include "shader/compiler.h"

namespace strobe::oracle {
namespace stored_numbers_test {

using Floats = std::vector<float>;

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr double kLargestHalf = 65504;

// Every half float from 0 up: exponents of 5 bits, mantissas of 10 bits. Exponent 0 has no leading 1.
const std::vector<double>& halves() {
  static const std::vector<double> all = [] {
    std::vector<double> list;
    for (int exponent = 0; exponent < 31; ++exponent)
      for (int mantissa = 0; mantissa < 1024; ++mantissa)
        list.push_back(exponent == 0 ? std::ldexp(mantissa, -24) : std::ldexp(1024 + mantissa, exponent - 25));
    return list;
  }();
  return all;
}

// Nearest half float to a number of at most 65504 in magnitude. Of two equally near ones the even mantissa wins, which
// has an even index.
double nearestOfAll(double value) {
  double magnitude = std::abs(value);
  auto above = std::lower_bound(halves().begin(), halves().end(), magnitude);
  size_t index = size_t(above - halves().begin());
  if (*above != magnitude) {
    double up = *above - magnitude, down = magnitude - halves()[index - 1];
    bool go_down = down < up || (down == up && (index - 1) % 2 == 0);
    if (go_down) --index;
  }
  return std::copysign(halves()[index], value);
}

struct Result {
  Floats values;
  uint32_t color_clamped = 0, velocity_clamped = 0, depth_lost = 0;
};

const char* kPreamble = R"(#version 460
#extension GL_GOOGLE_include_directive : require
#define velocity_format_fp32 0
#define velocity_format_fp16 1
#define color_format_fp32 0
#define color_format_fp16 1
#define depth_encoding_linear 0
#define depth_encoding_reversed 1
#define depth_encoding_inverse 2
#define depth_encoding_unorm24 3
#define SLICE_RASTER 0
layout(local_size_x = 64) in;
layout(set = 0, binding = 0, std430) buffer Io { vec4 io[]; };
struct Camera { float near; };
layout(set = 0, binding = 1, std430) buffer More { uint counts[3]; Camera scene_cameras[1]; };
void count_color_clamped(uint n) { atomicAdd(counts[0], n); }
void count_velocity_clamped(uint n) { atomicAdd(counts[1], n); }
void count_depth_lost(uint n) { atomicAdd(counts[2], n); }
)";

class StoredNumbers : public RenderTest {
 protected:
  // Runs `body` on `v`, which holds four values at a time. `given` defines the parameters as a pass would.
  static Result run(const std::string& given, const std::string& body, const Floats& values, float near = 0) {
    Floats padded = values;
    padded.resize((values.size() + 3) / 4 * 4, 0.0f);
    gpu::Device& device = bench().device();
    std::string main =
        "#include \"mixin/quantised.glsl\"\nvoid main() {\n  uint i = gl_GlobalInvocationID.x;\n"
        "  if (i >= io.length()) return;\n  vec4 v = io[i];\n  " +
        body + "\n  io[i] = v;\n}\n";
    const testing::TemporaryFolder folder;
    std::ofstream(folder / "stored.glsl") << main;
    auto spirv =
        shader::compile(bench().home(), {kPreamble + given, folder / "stored.glsl", ""}, shader::ShaderStage::Compute);

    gpu::Buffer io(device, "io", padded.size() * 4, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, gpu::Buffer::Memory::Host);
    gpu::Buffer more(device, "more", 16, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, gpu::Buffer::Memory::Host);
    std::memcpy(io.mapped(), padded.data(), padded.size() * 4);
    const uint32_t others[] = {0, 0, 0, std::bit_cast<uint32_t>(near)};
    std::memcpy(more.mapped(), others, sizeof(others));
    dispatch(device, spirv, io, more, uint32_t(padded.size() / 4));

    Result result{Floats(values.size())};
    std::memcpy(result.values.data(), io.mapped(), values.size() * 4);
    const uint32_t* counted = static_cast<const uint32_t*>(more.mapped());
    result.color_clamped = counted[0], result.velocity_clamped = counted[1], result.depth_lost = counted[2];
    return result;
  }

  static Result colors(const char* format, const Floats& values) {
    return run(fmt::format("#define PARAM_color_format color_format_{}\n", format), "v = quantisedColor(v);", values);
  }
  static Result velocities(const char* format, const Floats& values) {
    return run(fmt::format("#define PARAM_velocity_format velocity_format_{}\n", format),
               "v = vec4(quantisedVelocity(v.xy), quantisedVelocity(v.zw));", values);
  }
  static Result depths(const char* encoding, float near, const Floats& values) {
    return run(fmt::format("#define PARAM_depth_encoding depth_encoding_{}\n", encoding),
               "for (int c = 0; c < 4; ++c) v[c] = quantisedDepth(v[c]);", values, near);
  }

 private:
  static void dispatch(gpu::Device& device, const gpu::Spirv& spirv, const gpu::Buffer& io, const gpu::Buffer& more,
                       uint32_t threads) {
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (uint32_t i = 0; i < 2; ++i)
      bindings.push_back({i, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_ALL, nullptr});
    auto layout = gpu::makeSetLayout(device, "stored", bindings);
    gpu::DescriptorSet set(device, "stored", layout.get(), bindings);
    set.write(0, io);
    set.write(1, more);
    gpu::Pipeline pipeline = gpu::Pipeline::compute(device, "stored", spirv, {layout.get()});
    device.submit([&](VkCommandBuffer commands) {
      device.vk().CmdBindPipeline(commands, pipeline.bindPoint(), pipeline.handle());
      const VkDescriptorSet handle = set.handle();
      device.vk().CmdBindDescriptorSets(commands, pipeline.bindPoint(), pipeline.layout(), 0, 1, &handle, 0, nullptr);
      device.vk().CmdDispatch(commands, (threads + 63) / 64, 1, 1);
    });
  }
};

bool sameBits(float a, float b) { return std::bit_cast<uint32_t>(a) == std::bit_cast<uint32_t>(b); }

// Every half float, every midpoint between two neighbours, and the floats on both sides of the midpoint; then random
// ones.
Floats hardNumbers() {
  Floats values;
  for (size_t i = 0; i + 1 < halves().size(); ++i) {
    float middle = float((halves()[i] + halves()[i + 1]) / 2);
    for (float value : {float(halves()[i]), std::nextafter(middle, 0.0f), middle, std::nextafter(middle, kInf)})
      values.push_back(i % 2 ? value : -value);
  }
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-140, 16);
  for (int i = 0; i < 100000; ++i) values.push_back(float(std::min(std::exp2(exponent(random)), kLargestHalf)));
  return values;
}

TEST_F(StoredNumbers, HalfFloatsAreRoundedToNearest) {
  Floats given = hardNumbers();
  for (const Result& result : {colors("fp16", given), velocities("fp16", given)}) {
    size_t wrong = 0;
    for (size_t i = 0; i < given.size(); ++i) {
      bool right = sameBits(result.values[i], float(nearestOfAll(given[i])));
      if (!right && wrong++ < 5) ADD_FAILURE() << given[i] << " became " << result.values[i];
    }
    EXPECT_EQ(wrong, 0u);
    EXPECT_EQ(result.color_clamped + result.velocity_clamped, 0u);
  }
}

TEST_F(StoredNumbers, ColorsBeyondHalfFloatsAreClamped) {
  Result result = colors("fp16", {65504, 65505, 1e30f, -3e38f, 65504, -65504, 0, 1, -65519, 2, 3, 4});
  EXPECT_EQ(result.values, (Floats{65504, 65504, 65504, -65504, 65504, -65504, 0, 1, -65504, 2, 3, 4}));
  EXPECT_EQ(result.color_clamped, 2u);  // texels, not channels
}

TEST_F(StoredNumbers, DisplacementsBeyondHalfFloatsAreShortened) {
  Floats given = {131008, -32752, 3e38f, 3e38f, -1e20f, 0, 65504, 65504, 100000, 3, 12, -65505};
  Result result = velocities("fp16", given);
  EXPECT_EQ(result.velocity_clamped, 5u);
  for (size_t i = 0; i < given.size(); i += 2) {
    double x = result.values[i], y = result.values[i + 1], dx = given[i], dy = given[i + 1];
    EXPECT_EQ(std::max(std::abs(x), std::abs(y)), kLargestHalf) << dx << ", " << dy;
    double turn = std::abs(x * dy - y * dx) / (std::hypot(x, y) * std::hypot(dx, dy));  // sine of the angle between
    EXPECT_LE(turn, 0x1p-11) << dx << ", " << dy;
  }
}

TEST_F(StoredNumbers, NanAndInfinityAreKept) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Floats given = {kInf, -kInf, nan, 1, nan, kInf, nan, -kInf};
  for (const Result& result : {colors("fp16", given), velocities("fp16", given), depths("reversed", 0.1f, given),
                               depths("inverse", 0.1f, given), depths("unorm24", 0.1f, given)}) {
    for (size_t i = 0; i < given.size(); ++i) {
      if (std::isfinite(given[i])) continue;
      bool kept = std::isnan(given[i]) ? std::isnan(result.values[i]) : result.values[i] == given[i];
      EXPECT_TRUE(kept) << given[i] << " became " << result.values[i];
    }
    EXPECT_EQ(result.color_clamped + result.velocity_clamped + result.depth_lost, 0u);
  }
}

TEST_F(StoredNumbers, SinglePrecisionIsKeptBitForBit) {
  Floats given = hardNumbers();
  for (uint32_t bits : {0x7f800000u, 0xff800000u, 0x7fc00001u, 0x80000000u, 0x00000001u, 0x7f7fffffu, 0xbf800001u})
    given.push_back(std::bit_cast<float>(bits));
  for (const Result& result : {colors("fp32", given), velocities("fp32", given), depths("linear", 0.1f, given)}) {
    EXPECT_EQ(std::memcmp(result.values.data(), given.data(), given.size() * 4), 0);
    EXPECT_EQ(result.color_clamped + result.velocity_clamped + result.depth_lost, 0u);
  }
}

// Depths from the near distance to `far` near distances, in equal steps of the logarithm.
Floats depthsUpTo(float near, double far) {
  Floats list;
  for (int i = 0; i < 20000; ++i) list.push_back(float(near * std::pow(far, (i + 0.5) / 20000)));
  return list;
}

// A division is exact to 2.5 units in the last place on any device, and a unit is at most 2^-23 of the number.
constexpr double kDivision = 2.5 * 0x1p-23;

TEST_F(StoredNumbers, ReversedAndInverseDepthsErrByTwoDivisions) {
  for (const char* encoding : {"reversed", "inverse"})
    for (float near : {1e-6f, 0.01f, 1.0f, 1000.0f}) {
      Floats given = depthsUpTo(near, 1e12), stored = depths(encoding, near, given).values;
      double worst = 0;
      for (size_t i = 0; i < given.size(); ++i) worst = std::max(worst, std::abs(double(stored[i]) / given[i] - 1));
      EXPECT_LE(worst, 2 * kDivision) << encoding << " " << near;
      EXPECT_GT(worst, 0x1p-25) << encoding << " " << near;  // single precision is used
      EXPECT_TRUE(std::is_sorted(stored.begin(), stored.end())) << encoding << " " << near;
    }
}

// The code is the integer nearest to (1 - n/z) (2^24 - 1), at most half a step off. The relative error of z is z/(n
// 2^25).
TEST_F(StoredNumbers, Unorm24ErrsByHalfAStep) {
  const double steps = 16777215, half_step = 0.5 / steps;
  for (float near : {1e-6f, 0.01f, 1.0f, 1000.0f}) {
    Floats given = depthsUpTo(near, 1e7);
    Result result = depths("unorm24", near, given);
    for (size_t i = 0; i < given.size(); ++i) {
      double n = near, z = given[i], back = result.values[i];
      double step_error = std::abs((1 - n / back) - (1 - n / z));
      // n/z is at most 1, and is rounded in single precision by encoding and by decoding.
      ASSERT_LE(step_error, half_step + 3 * kDivision * n / z) << near << " " << z;
      if (z < 100 * n || z > 1e5 * n) continue;
      // 1 % of slack: the bound is relative to n/z, and z is its inverse.
      ASSERT_LE(std::abs(back / z - 1), 1.01 * z / (n * 0x1p25) + 3 * kDivision) << near << " " << z;
    }
    EXPECT_TRUE(std::is_sorted(result.values.begin(), result.values.end())) << near;
    EXPECT_EQ(result.depth_lost, 0u);
  }
}

TEST_F(StoredNumbers, Unorm24MergesDepthsWithinAStep) {
  Floats given;
  for (int i = 0; i < 4096; ++i) given.push_back(1e6f + float(i));  // steps there: z^2 / 2^24 = 60000 near distances
  Floats stored = depths("unorm24", 1, given).values;
  EXPECT_LE(std::unique(stored.begin(), stored.end()) - stored.begin(), 2);
}

TEST_F(StoredNumbers, TooDistantDepthsBecomeSkyAndAreCounted) {
  Result result = depths("unorm24", 0.5f, {1e6f, 0.49f * 0x1p25f, 0.51f * 0x1p25f, 1e30f, kInf, 1, 1, 1});
  EXPECT_LT(result.values[1], kInf);
  EXPECT_EQ(result.values[2], kInf);
  EXPECT_EQ(result.values[3], kInf);
  EXPECT_EQ(result.values[4], kInf);
  EXPECT_EQ(result.depth_lost, 2u);  // the sky itself is not lost
}

TEST_F(StoredNumbers, EmptyAndNearDepthsAreKept) {
  for (const char* encoding : {"reversed", "inverse", "unorm24"}) {
    Floats stored = depths(encoding, 0.1f, {0, 0.1f, 0.05f, -1}).values;
    EXPECT_EQ(stored[0], 0) << encoding;
    EXPECT_NEAR(stored[1], 0.1, 0.1 * 2 * kDivision) << encoding;
    double nearer = std::string(encoding) == "inverse" ? 0.05 : 0.1;
    EXPECT_NEAR(stored[2], nearer, nearer * 2 * kDivision) << encoding;
    EXPECT_EQ(stored[3], -1) << encoding;  // readers treat it as 0
  }
}

}  // namespace stored_numbers_test
}  // namespace strobe::oracle
