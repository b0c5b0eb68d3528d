// What the window can export, by the ending of the file's name.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace triscope {

struct ExportFormat {
  enum class Content : std::uint8_t { mesh, domain, picture, sweep };
  const char* extension;  // ".msh"
  Content content;
  const char* what;  // the format has, for people
};
std::span<const ExportFormat> exportFormats();
/// Null where the name ends in none of them.
const ExportFormat* exportFormatOf(const std::string& path);

}  // namespace triscope
