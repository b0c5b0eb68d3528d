// Writing meshes, domains, pictures and sweeps, on a thread of its own.
#pragma once

#include <string>

#include "ui/app/desk.h"
#include "ui/model/background_job.h"

namespace triscope {

class Exporting {
 public:
  explicit Exporting(Desk& desk) : desk_(desk) {}

  /// What is written goes by the extension.
  void writeTo(const std::string& path);
  /// Takes over what became of it.
  void follow();
  [[nodiscard]] bool ready() const { return job_.ready(); }

 private:
  Desk& desk_;
  BackgroundJob job_;
  std::string path_;  // being written
};

/// Where a file of what is shown may go: in the working directory, named after the domain.
std::string suggestedPath(const Desk& desk, const char* extension);
/// Likewise, where no file is yet.
std::string freePath(const Desk& desk, const char* extension);

}  // namespace triscope
