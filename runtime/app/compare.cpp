// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <memory>
#include <string>

#include "app/commands.h"
#include "base/error.h"
#include "base/json.h"
#include "base/log.h"
#include "image/comparison.h"
#include "image/exr.h"
#include "image/false_colour.h"
#include "image/png.h"
#include "page/table.h"

namespace strobe::app {
namespace {

struct Request {
  std::string test, reference, mask, layer, flip_map;
  bool json = false;
  double pixels_per_degree = image::kPixelsPerDegree;
  image::Exposures exposures;
  bool given_exposures = false;
};

std::string shown(const Json& value) {
  if (value.is_null()) return "-";
  return value.is_string() ? value.get<std::string>() : fmt::format("{:.6g}", value.get<double>());
}

void printTable(const Json& numbers) {
  page::Table table{"", {"measure", {"value", true}, "", ""}};
  auto add = [&](const char* name, const char* key, const char* unit = "", std::string note = "") {
    table.add({name, shown(numbers.at(key)), unit, std::move(note)});
  };
  add("MSE", "mse");
  add("RMSE", "rmse");
  add("PSNR", "psnr", "dB", "clamped, sRGB-encoded");
  add("relMSE", "relmse", "", "without the worst 0.1 %: " + shown(numbers.at("relmse_trimmed")));
  add("SMAPE", "smape");
  add("SSIM", "ssim", "", "clamped, sRGB-encoded");
  add("MS-SSIM", "ms_ssim");
  add("LDR-FLIP", "ldr_flip", "", "largest " + shown(numbers.at("ldr_flip_max")));
  if (!numbers.at("hdr_flip").is_null())
    add("HDR-FLIP", "hdr_flip", "",
        fmt::format("largest {}; {} exposures, {:.4f} to {:.4f}, from {}", shown(numbers.at("hdr_flip_max")),
                    numbers.at("hdr_flip_exposures").get<int>(), numbers.at("hdr_flip_start").get<double>(),
                    numbers.at("hdr_flip_stop").get<double>(), numbers.at("hdr_flip_source").get<std::string>()));
  fmt::print("{}\n{} pixels\n", page::textOf(table), numbers.at("pixels").get<size_t>());
}

// Writes an error map: values in a .exr file, the colour map magma in a PNG otherwise.
void writeMap(const Path& file, const image::Image& map) {
  if (file.extension() != ".exr") return image::writePng(file, image::heatMap(map, 0, 1));
  image::ExrFile content;
  content.add("", {"Y"}, map);
  image::writeExr(file, content);
}

void warnOf(const std::string& file, const image::ComparedPicture& picture) {
  for (const std::string& note : picture.notes) warn(file + ": " + note);
}

void compare(const Request& request) {
  if (request.exposures.start > request.exposures.stop) throw Error("--start is above --stop", {}, 2);
  image::ComparedPicture test = image::readPicture(request.test, request.layer);
  image::ComparedPicture reference = image::readPicture(request.reference, request.layer);
  image::ComparedPicture mask = request.mask.empty() ? image::ComparedPicture() : image::readMask(request.mask);
  image::alignPictures(test, reference, mask);
  warnOf(request.test, test), warnOf(request.reference, reference), warnOf(request.mask, mask);
  image::CompareOptions options;
  options.hdr = test.hdr && reference.hdr;
  options.pixels_per_degree = request.pixels_per_degree;
  if (request.given_exposures) options.exposures = request.exposures;
  image::ImageComparison result = image::compareImages(test.linear, reference.linear, mask.linear, options);
  if (!request.flip_map.empty()) writeMap(request.flip_map, result.map);
  if (!request.json) return printTable(result.numbers);
  fmt::print("{}\n", result.numbers.dump(2));
}

}  // namespace

void registerCompare(CLI::App& program) {
  auto request = std::make_shared<Request>();
  CLI::App* command = program.add_subcommand("compare", "Compute error metrics of two images (PNG or OpenEXR)");
  command->footer(
      "PNG values are decoded from sRGB, or by the gAMA and cHRM of the file. OpenEXR files are aligned by\ntheir "
      "display windows; their colours are converted to Rec. 709. PSNR and SSIM are measured on clamped,\nsRGB-encoded "
      "values.\nHDR-FLIP needs two OpenEXR files. JSON: null is \"not measured\", \"inf\" the PSNR of equal images.");
  command->add_option("test", request->test, "image to test")->required()->type_name("FILE");
  command->add_option("reference", request->reference, "reference image")->required()->type_name("FILE");
  command->add_option("--mask", request->mask, "count only pixels where this image is at least 0.5")->type_name("FILE");
  command->add_option("--layer", request->layer, "compare this layer of OpenEXR files")->type_name("NAME");
  command->add_option("--flip-map", request->flip_map, "write the error map: .png in colour, .exr as values")
      ->type_name("FILE");
  command->add_flag("--json", request->json, "print JSON");
  command->add_option("--ppd", request->pixels_per_degree, "pixels per degree of visual angle")
      ->check(CLI::Range(1.0, 1000.0))
      ->capture_default_str();
  CLI::Option* start = command->add_option("--start", request->exposures.start, "first exposure of HDR-FLIP, in stops");
  CLI::Option* stop = command->add_option("--stop", request->exposures.stop, "last exposure of HDR-FLIP, in stops");
  CLI::Option* count = command->add_option("--exposures", request->exposures.count, "number of exposures of HDR-FLIP")
                           ->check(CLI::Range(1, 1000));
  start->needs(stop)->needs(count);
  stop->needs(start);
  count->needs(start);
  command->callback([request, start] {
    request->given_exposures = start->count() > 0;
    compare(*request);
  });
}

}  // namespace strobe::app
