// The lower part of a dialog that writes a file: its path, and the buttons that write it or close the dialog.
#pragma once

#include <string>

#include "ui/model/view.h"

namespace triscope {

/// The field; it has the focus when the dialog opens. True when Enter was pressed in it. Tests know it as `name`.path.
bool pathField(const View& view, const char* name, std::string& path);

/// The buttons, `verb` and Close, known as `name`.ok and `name`.close. True when `verb` was pressed; it is disabled
/// while there is a reason against it, which is its tooltip then instead of `help`.
bool writeOrClose(const View& view, Orders& orders, const char* name, const char* verb, const std::string& reason,
                  const char* help);

}  // namespace triscope
