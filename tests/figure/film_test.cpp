// SPDX-License-Identifier: MIT
// Films have the frames of their figures, the same bytes each time, and errors for missing parts.
#include "figure/film.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "figures.h"
#include "program/run.h"

namespace strobe::figure {
namespace film_test {

using strobe::testing::contentOf;
using strobe::testing::TemporaryFolder;

bool hasFfmpeg() { return strobe::testing::runLine("ffmpeg -version >/dev/null 2>&1").exit_code == 0; }

const char* const kPair = R"(name = "pair", shot = "still", columns = { { arm = "plain" }, { arm = "truth" } },
  caption = "{rmse}, step {step}", fps = 5, )";

TEST(Film, HasTheFramesOfItsFigureAndReproducibleBytes) {
  if (!hasFfmpeg()) GTEST_SKIP() << "no ffmpeg";
  TemporaryFolder folder;
  Json data = dataOf(kPair + std::string("format = 'mkv'"), "film");
  std::vector<Path> files = writeFilm(data, findTaken, 3, folder.path() / "a", "truth");
  ASSERT_EQ(files, std::vector<Path>{folder.path() / "a/pair.mkv"});
  EXPECT_TRUE(contentOf(files[0]) == contentOf(writeFilm(data, findTaken, 3, folder.path() / "b", "truth")[0]));
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "a"))
    EXPECT_EQ(entry.path().filename(), "pair.mkv") << "nothing else is left";

  // FFV1 is lossless: ffmpeg decodes the pixels of the figure at each step.
  std::string out = folder / "frames.rgb";
  auto outcome = strobe::testing::runLine("ffmpeg -v error -i '" + files[0].string() +
                                          "' -f rawvideo -pix_fmt rgb24 '" + out + "'");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::string frames = contentOf(out);
  FigureData film = figureFrom(data);
  std::string expected;
  for (int step = 0; step < 3; ++step) {
    Layout layout = layoutOf(film, findTaken, "truth", step, Captions::one_line);
    int width = layout.width() + layout.width() % 2, height = layout.height() + layout.height() % 2;
    Canvas canvas(Canvas::Kind::pixels, width, height);
    layout.draw(canvas);
    for (float value : canvas.pixels().values) expected.push_back(char(std::lround(255 * value)));
  }
  EXPECT_EQ(frames.size(), expected.size());
  EXPECT_TRUE(frames == expected);
}

TEST(Film, PlayersSupportTheDefaultFormat) {
  if (!hasFfmpeg()) GTEST_SKIP() << "no ffmpeg";
  TemporaryFolder folder;
  Json data = dataOf("name = 'pair', shot = 'still', arm = 'plain'", "film");
  std::vector<Path> files = writeFilm(data, findTaken, 4, folder.path() / "a");
  EXPECT_TRUE(contentOf(files[0]) == contentOf(writeFilm(data, findTaken, 4, folder.path() / "b")[0]));
  auto probe = strobe::testing::runLine(
      "ffprobe -v error -count_frames -show_entries stream=codec_name,pix_fmt,r_frame_rate,nb_read_frames:format_tags "
      "-of "
      "default=nw=1 '" +
      files[0].string() + "'");
  EXPECT_NE(probe.out.find("codec_name=h264"), std::string::npos) << probe.out << probe.err;
  EXPECT_NE(probe.out.find("pix_fmt=yuv420p"), std::string::npos) << probe.out;
  EXPECT_NE(probe.out.find("r_frame_rate=12/1"), std::string::npos) << "the frame rate of the shot: " << probe.out;
  EXPECT_NE(probe.out.find("nb_read_frames=4"), std::string::npos) << probe.out;
  EXPECT_EQ(probe.out.find("creation_time"), std::string::npos) << probe.out;
}

TEST(Film, WithoutFfmpegThePackageIsNamed) {
  TemporaryFolder folder;
  Json data = dataOf("name = 'pair', shot = 'still', arm = 'plain'", "film");
  std::string path = std::getenv("PATH");
  ::setenv("PATH", folder.path().c_str(), 1);
  std::string text;
  try {
    writeFilm(data, findTaken, 2, folder.path());
  } catch (const Error& error) {
    text = error.what();
  }
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_NE(text.find("film 'pair' needs ffmpeg, which is not installed (Debian package ffmpeg)"), std::string::npos)
      << text;
  EXPECT_NE(text.find("x.lua:"), std::string::npos) << text;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "pair.mp4"));
}

// A missing picture ends the film and the ffmpeg process.
TEST(Film, MissingPictureEndsTheFilm) {
  if (!hasFfmpeg()) GTEST_SKIP() << "no ffmpeg";
  TemporaryFolder folder;
  Json data = dataOf("name = 'pair', shot = 'still', arm = 'plain'", "film");
  FindTaken find = [](const std::string& shot, const std::string& arm, int step) -> const Taken& {
    if (step == 2) throw Error("step 2 is missing");
    return findTaken(shot, arm, step);
  };
  EXPECT_THROW(writeFilm(data, find, 4, folder.path()), Error);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace film_test
}  // namespace strobe::figure
