// The element that the panels Why and History are about.
#pragma once

#include <string_view>

#include "ui/model/view.h"

namespace triscope {

/// Draws its name, which tests know as `name`. False when nothing is selected: the invitation is drawn instead.
bool drawSubject(const View& view, const char* invitation, std::string_view name);

}  // namespace triscope
