// SPDX-License-Identifier: MIT
// Container of a glTF 2.0 asset: its JSON, its buffers and the values of its accessors. The file is not trusted: every
// index, size and type is checked before use. Errors are one line.
#pragma once

#include <map>

#include "base/home.h"
#include "scene/gltf_json.h"
#include "scene/image_decode.h"
#include "scene/scene.h"

namespace strobe::scene {

// Values of an accessor: `count` elements of `width` components. Normalised integers are already divided.
struct Values {
  size_t count = 0;
  int width = 0;
  std::vector<double> numbers;
  double at(size_t element, int component) const { return numbers[element * width + component]; }
  dvec2 vector2(size_t i) const { return {at(i, 0), at(i, 1)}; }
  dvec3 vector3(size_t i) const { return {at(i, 0), at(i, 1), at(i, 2)}; }
  dvec4 vector4(size_t i) const { return {at(i, 0), at(i, 1), at(i, 2), at(i, 3)}; }
};

// Storage format of the elements of an accessor.
struct AccessorFormat {
  std::string type;  // "VEC3"
  int component_type = 0;
  bool normalized = false;
  size_t count = 0;
  int width() const;           // number of components; 0 for an unknown type
  size_t elementSize() const;  // bytes
};

// Reader of a .glb or .gltf file with checked access to its buffers, accessors and encoded images. Compressed buffers
// are decoded.
class GltfFile : public GltfJson {
 public:
  // Reads a .glb or .gltf with all its buffers, and decodes compressed buffers. Throws `Error` for a file that is
  // missing, cut short, of another version or form (`requireForm`), or that requires an unsupported extension. Files
  // named by the asset must lie in its folder, links followed, unless `allow_outside`.
  GltfFile(const Path& file, bool allow_outside);

  const Path& path() const { return path_; }
  // Files read so far, the glTF file first.
  const std::vector<SourceFile>& files() const { return files_; }

  // True if the glTF file may name `file`.
  bool mayRead(const Path& file) const { return allow_outside_ || liesIn(file, path_.parent_path()); }
  // Returns the content of a file and adds the file to `files`.
  std::string readFile(const Path& file);

  // Total size of the files read so far, bytes.
  size_t bytesRead() const { return bytes_read_; }
  AccessorFormat format(int accessor) const;

  // `where` is the place in errors, for example "meshes[2].primitives[0]". `types` are the accepted accessor types.
  Values accessor(int index, const std::string& where, const std::vector<std::string>& types) const;
  std::vector<uint32_t> indices(int index, const std::string& where) const;
  // Encoded bytes of an image.
  std::vector<uint8_t> imageBytes(int index);

 private:
  struct View {
    const uint8_t* data = nullptr;
    size_t size = 0;
    size_t stride = 0;  // 0: tightly packed
  };
  void readContainer();
  void readChunks(const std::vector<uint8_t>& bytes, size_t& json_at, size_t& json_size);
  void checkVersion() const;
  void readBuffers();
  bool isFallback(const Json& buffer) const;
  void requireElements() const;
  void decodeViews();
  void decodePrimitives();
  void decodePrimitive(const Json& json, const Json& extension, const std::string& where);
  void keepDecoded(int accessor, std::vector<uint8_t> bytes, const std::string& where);
  std::vector<uint8_t> uriBytes(const std::string& uri, const std::string& where);
  View view(int index, const std::string& where) const;
  View stored(const Json& json, const std::string& where) const;
  const uint8_t* elements(const Json& accessor, size_t count, size_t element_size, size_t& stride,
                          const std::string& where) const;
  void applySparse(const Json& accessor, Values& values, int component_type, bool normalized,
                   const std::string& where) const;

  Path path_;  // absolute
  bool allow_outside_ = false;
  std::vector<SourceFile> files_;
  std::vector<uint8_t> binary_chunk_;
  bool has_binary_chunk_ = false;
  size_t bytes_read_ = 0;
  std::vector<std::vector<uint8_t>> buffers_;
  std::map<int, std::vector<uint8_t>> decoded_views_;
  std::map<int, std::vector<uint8_t>> decoded_accessors_;  // tightly packed
};

}  // namespace strobe::scene
