// SPDX-License-Identifier: MIT
// Decompression of the streams of a glTF file (gltf_file.h).
#include "scene/gltf_compression.h"
#include "scene/gltf_file.h"

namespace strobe::scene {

void GltfFile::decodeViews() {
  const Json& views = all("bufferViews");
  for (size_t i = 0; i < views.size(); ++i) {
    bool present = false;
    const Json& json = extension(views[i], "EXT_meshopt_compression", &present);
    if (!present) continue;
    const std::string where = fmt::format("bufferViews[{}].extensions.EXT_meshopt_compression", i);
    const View source = stored(json, where);
    MeshoptStream stream = {{source.data, source.size}, size(json, "count", std::nullopt, where), source.stride};
    stream.mode = text(json, "mode", where);
    stream.filter = text(json, "filter", where);
    const size_t length = size(views[i], "byteLength", std::nullopt, where);
    if (length != stream.count * stream.stride)
      refuse(where, fmt::format("{} elements of {} bytes do not match the {} bytes of the view", stream.count,
                                stream.stride, length));
    try {
      decoded_views_[int(i)] = decodeMeshopt(stream);
    } catch (const std::exception& error) {
      refuse(where, error.what());
    }
  }
}

void GltfFile::decodePrimitives() {
  const Json& meshes = all("meshes");
  for (size_t m = 0; m < meshes.size(); ++m) {
    const Json& primitives = list(meshes[m], "primitives", "meshes");
    for (size_t p = 0; p < primitives.size(); ++p) {
      bool present = false;
      const Json& json = extension(primitives[p], "KHR_draco_mesh_compression", &present);
      const std::string where = fmt::format("meshes[{}].primitives[{}].extensions.KHR_draco_mesh_compression", m, p);
      if (present) decodePrimitive(primitives[p], json, where);
    }
  }
}

void GltfFile::decodePrimitive(const Json& primitive, const Json& json, const std::string& where) {
  if (size(primitive, "mode", 4, where) != 4) refuse(where, "its primitive is not a list of triangles");
  const int indices = index(primitive, "indices", "accessors", where);
  if (indices < 0) refuse(where, "its primitive has no indices");
  const View source = view(index(json, "bufferView", "bufferViews", where), where);
  DracoStream stream = {{source.data, source.size}};
  stream.indices = format(indices).count;
  stream.index_type = format(indices).component_type;
  std::map<std::string, int> accessors;
  for (const auto& [name, id] : json["attributes"].items()) {
    const int accessor = index(primitive["attributes"], name, "accessors", where);
    if (accessor < 0) refuse(where, fmt::format("its primitive has no attribute {}", name));
    const AccessorFormat asked = format(accessor);
    if (!accessors.empty() && asked.count != stream.vertices)
      refuse(where, fmt::format("{} has {} elements, not {}", name, asked.count, stream.vertices));
    stream.vertices = asked.count;
    stream.asked[name] = {uint32_t(size(json["attributes"], name, std::nullopt, where)), asked.component_type,
                          asked.width()};
    accessors[name] = accessor;
  }
  try {
    DracoMesh mesh = decodeDraco(stream);
    keepDecoded(indices, std::move(mesh.indices), where);
    for (const auto& [name, accessor] : accessors) keepDecoded(accessor, std::move(mesh.attributes[name]), where);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    refuse(where, fmt::format("its stream cannot be decoded: {}", error.what()));
  }
}

// Primitives may share a stream and its accessors, but every accessor has only one content.
void GltfFile::keepDecoded(int accessor, std::vector<uint8_t> bytes, const std::string& where) {
  auto [known, is_new] = decoded_accessors_.try_emplace(accessor, bytes);
  if (!is_new && known->second != bytes)
    refuse(where, fmt::format("accessors[{}] already has the contents of another stream", accessor));
}

}  // namespace strobe::scene
