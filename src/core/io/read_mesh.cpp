#include "core/io/read_mesh.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

namespace triscope {
namespace {

namespace fs = std::filesystem;

Result<std::string> textOf(const std::string& path) {
  const auto failure = [&](std::string message) {
    return Error{.kind = ErrorKind::no_input,
                 .message = std::move(message),
                 .hint = "check the name and the permissions",
                 .file = path,
                 .loop = {}};
  };
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return failure("is a folder, not a mesh file");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) return failure(fmt::format("cannot open: {}", std::strerror(errno == 0 ? ENOENT : errno)));
  std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (in.bad()) return failure("cannot read to the end");
  return text;
}

Result<MeshFile> readTriangle(const std::string& path) {
  std::string texts[3];
  const char* const extensions[3] = {".node", ".ele", ".poly"};
  for (int i = 0; i < 3; ++i) {
    const std::string part = fs::path(path).replace_extension(extensions[i]).string();
    std::error_code ignored;
    if (i == 2 && !fs::exists(part, ignored)) continue;
    auto text = textOf(part);
    if (!text) return text.error();
    texts[i] = std::move(*text);
  }
  return parseTriangle(texts[0], texts[1], texts[2]);
}

template <Result<MeshFile> (*parse)(std::string_view)>
Result<MeshFile> readOne(const std::string& path) {
  const auto text = textOf(path);
  if (!text) return text.error();
  return parse(*text);
}

struct Format {
  const char* extension;
  Result<MeshFile> (*read)(const std::string& path);
};

constexpr Format kFormats[] = {
    {".msh", readOne<parseMsh>}, {".vtu", readOne<parseVtu>}, {".node", readTriangle},     {".ele", readTriangle},
    {".su2", readOne<parseSu2>}, {".off", readOne<parseOff>}, {".obj", readOne<parseObj>},
};

}  // namespace

std::string meshFormatsRead() {
  std::string list;
  for (const Format& format : kFormats) list += (list.empty() ? "" : ", ") + std::string(format.extension);
  return list;
}

Result<MeshFile> readMesh(const std::string& path) {
  const std::string extension = fs::path(path).extension().string();
  for (const Format& format : kFormats) {
    if (extension != format.extension) continue;
    auto file = format.read(path);
    if (file || !file.error().file.empty()) return file;
    Error error = file.error();
    error.file = path;
    return error;
  }
  return Error{.kind = ErrorKind::usage,
               .message = fmt::format("no mesh format has the extension '{}'", extension),
               .hint = "known are " + meshFormatsRead(),
               .file = path,
               .loop = {}};
}

}  // namespace triscope
