// SPDX-License-Identifier: MIT
#include "figure/film.h"

#include <filesystem>
#include <utility>

#include "base/process.h"
#include "base/temporary_file.h"

namespace strobe::figure {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> encodingOf(const std::string& format) {
  if (format == "mkv")
    return {"-c:v", "ffv1", "-level", "3", "-g", "1", "-slices", "4", "-pix_fmt", "bgr0", "-f", "matroska"};
  return {"-vf",
          "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int+bitexact,format=yuv420p",
          "-c:v",
          "libx264",
          "-preset",
          "medium",
          "-crf",
          "12",
          "-colorspace",
          "bt709",
          "-color_primaries",
          "bt709",
          "-color_trc",
          "iec61966-2-1",
          "-color_range",
          "tv",
          "-movflags",
          "+faststart",
          "-f",
          "mp4"};
}

std::vector<std::string> commandOf(const std::string& format, int width, int height, double fps, const Path& file) {
  std::vector<std::string> command = {"ffmpeg", "-hide_banner", "-loglevel", "error", "-y",
                                      // input
                                      "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", fmt::format("{}x{}", width, height),
                                      "-r", fmt::format("{:.9g}", fps), "-i", "pipe:0",
                                      // reproducible output
                                      "-an", "-map_metadata", "-1", "-threads", "1", "-filter_threads", "1", "-fflags",
                                      "+bitexact", "-flags:v", "+bitexact"};
  for (const std::string& argument : encodingOf(format)) command.push_back(argument);
  command.push_back("file:" + file.string());
  return command;
}

bool hasFfmpeg() {
  try {
    return run({.arguments = {"ffmpeg", "-version"}, .wall_s = 60}).succeeded();
  } catch (const Error&) {
    return false;
  }
}

int evenOf(int length) { return length + length % 2; }

// Frame rate of the film, or of the first shot in the film.
double fpsOf(const FigureData& film, const FindTaken& find) {
  if (film.fps > 0) return film.fps;
  const FigureCell& cell = film.cells.at(0);
  const Taken& taken = find(cell.shot, cell.arm, cell.step.value_or(0));
  const Json& record = taken.picture->record;
  double fps = record.contains("shot") ? record["shot"].value("fps", 0.0) : 0.0;
  return fps > 0 ? fps : 24;
}

}  // namespace

std::vector<Path> writeFilm(const Json& data, const FindTaken& find, int steps, const Path& folder,
                            const std::string& truth_arm) {
  FigureData film = figureFrom(data);
  if (steps < 1) throw Error(fmt::format("film '{}' has no frames", film.name), film.place);
  if (!hasFfmpeg())
    throw Error(fmt::format("film '{}' needs ffmpeg, which is not installed (Debian package ffmpeg)", film.name),
                film.place);
  int step = 0;
  int width = 0, height = 0;  // of the first frame; even, because two neighbouring pixels share their colour
  // RGB bytes of the next frame, of the size of the first frame; "" after the last frame.
  auto next = [&]() -> std::string {
    if (step == steps) return "";
    Layout layout = layoutOf(film, find, truth_arm, step, Captions::one_line);
    if (width == 0) width = evenOf(layout.width()), height = evenOf(layout.height());
    if (layout.width() > width || layout.height() > height)
      throw Error(fmt::format("step {} of film '{}' is larger than the first: {}x{} instead of {}x{}", step, film.name,
                              layout.width(), layout.height(), width, height),
                  film.place);
    Canvas canvas(Canvas::Kind::pixels, width, height);
    layout.draw(canvas);
    ++step;
    return image::levelsOf(canvas.pixels());
  };
  std::string first = next();
  fs::create_directories(folder);
  Path file = folder / (film.name + "." + film.format);
  TemporaryFile temporary(file);
  Program ffmpeg;
  ffmpeg.arguments = commandOf(film.format, width, height, fpsOf(film, find), temporary.path());
  ffmpeg.input = [&] { return first.empty() ? next() : std::exchange(first, {}); };
  ProgramEnd end = run(ffmpeg);
  if (!end.succeeded())
    throw Error(fmt::format("film '{}': ffmpeg ended with {}: {}", film.name, end.code(), end.errors), film.place);
  temporary.keep();
  return {file};
}

}  // namespace strobe::figure
