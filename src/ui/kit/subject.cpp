#include "ui/kit/subject.h"

#include "core/base/capitalised.h"
#include "ui/kit/widgets.h"

namespace triscope {

bool drawSubject(const View& view, const char* invitation, std::string_view name) {
  const std::optional<Ref>& about = view.debug.answers.about;
  if (!about) {
    heading(view, "Nothing is selected");
    muted(view, invitation);
    return false;
  }
  title(view, capitalised(nameOf(*about)), name);
  return true;
}

}  // namespace triscope
