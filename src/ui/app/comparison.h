// Two runs side by side: pinning A, and keeping it where B stands.
#pragma once

#include "ui/app/desk.h"
#include "ui/model/pinned_run.h"

namespace triscope {

class Comparison {
 public:
  explicit Comparison(Desk& desk) : desk_(desk) {}

  /// Pins the present run as A, or lets A go. A context of OpenGL must be current.
  void toggle();
  void letGo();
  /// Takes A where B stands; lets it go where B is of another domain.
  void follow();
  bool poll() { return pinned_ != nullptr && pinned_->poll(); }
  [[nodiscard]] bool busy() const { return pinned_ != nullptr && pinned_->session().busy(); }
  [[nodiscard]] const PinnedRun* pinned() const { return pinned_.get(); }
  void draw(const ViewOptions& options);

 private:
  Desk& desk_;
  std::unique_ptr<PinnedRun> pinned_;
};

}  // namespace triscope
