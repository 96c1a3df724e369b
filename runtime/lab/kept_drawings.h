// SPDX-License-Identifier: MIT
// Drawings kept for later pictures: a picture whose graph has the shape of an earlier picture reuses its images and
// pipelines.
#pragma once

#include <list>
#include <memory>
#include <optional>

#include "lab/drawing.h"

namespace strobe::lab {

// Drawings of a bench, within limits of number and bytes.
class KeptDrawings {
 public:
  // The bench must outlive the drawings.
  explicit KeptDrawings(Workbench& bench) : bench_(bench) {}

  Workbench& bench() { return bench_; }

  // Drawing of a plan: a kept drawing of the same shape, or a new one. Does not check if shaders have changed. Throws
  // `Error`.
  Drawing& of(const std::shared_ptr<HeldScene>& scene, const Planned& planned,
              std::shared_ptr<const Evaluation> evaluation);

  // Picture from the present files. Scripts, scene and shaders are reused only while no file has changed. Settings that
  // change only numbers are applied without running scripts. `progress` (may be empty): iterations done, total.
  // `id_coverage`: see `Drawing::capture`.
  Picture render(const Shot& shot, const std::function<void(int, int)>& progress = {}, bool id_coverage = false);

  // Limits: bytes of the images, and number of drawings. A new drawing evicts the least recently used ones.
  size_t most_bytes = size_t{512} << 20;
  size_t most = 32;

 private:
  struct Kept {
    std::unique_ptr<Drawing> drawing;
    std::optional<Stamps> shaders;  // stamps of the shader files; empty: not known to be current
  };
  using Place = std::list<Kept>::iterator;
  Place find(const Planned& planned, const HeldScene& scene);
  void makeRoom(const plan::Plan& plan);
  void dropIfStale(const Planned& planned, const HeldScene& scene);

  Workbench& bench_;
  std::list<Kept> kept_;  // most recently used first
};

}  // namespace strobe::lab
