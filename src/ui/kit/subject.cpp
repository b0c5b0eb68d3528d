#include "ui/kit/subject.h"

#include <string>

#include "ui/kit/widgets.h"

namespace triscope {

bool drawSubject(const View& view, const char* invitation, std::string_view name) {
  const std::optional<Ref>& about = view.debug.answers.about;
  if (!about) {
    heading(view, "Nothing is selected");
    muted(view, invitation);
    return false;
  }
  std::string text = nameOf(*about);
  text[0] = static_cast<char>(text[0] - 'a' + 'A');
  title(view, text, name);
  return true;
}

}  // namespace triscope
