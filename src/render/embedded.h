// Files that are built into the program (cmake/Embed.cmake writes the definitions).
#pragma once

#include <span>
#include <string_view>

namespace triscope {

struct EmbeddedFile {
  std::string_view name;  // without folder
  std::span<const unsigned char> bytes;
};

/// assets/fonts: Inter-Regular.otf, Inter-SemiBold.otf, DejaVuSansMono.ttf
std::span<const EmbeddedFile> embeddedFonts();
/// shaders/
std::span<const EmbeddedFile> embeddedShaders();
/// assets/domains/
std::span<const EmbeddedFile> embeddedSamples();

/// Bytes of the file of that name, empty when there is none.
inline std::span<const unsigned char> findEmbedded(std::span<const EmbeddedFile> files, std::string_view name) {
  for (const EmbeddedFile& file : files) {
    if (file.name == name) return file.bytes;
  }
  return {};
}

}  // namespace triscope
