// Formats for space hold a z with every point; a plane mesh has the same one everywhere.
#pragma once

#include "core/base/text_scanner.h"

namespace triscope {

/// Takes the z of one point after the other and fails at the first that leaves the plane of the first.
class PlaneCheck {
 public:
  void take(double z, TextScanner& in) {
    if (first_) z_ = z;
    first_ = false;
    if (z != z_) {
      in.fail(fmt::format("the mesh leaves the plane: z is {} here and {} before", z, z_),
              "only meshes in a plane of constant z can be read");
    }
  }

 private:
  bool first_ = true;
  double z_ = 0.0;
};

}  // namespace triscope
