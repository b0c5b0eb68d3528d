// What the menu Edit offers, and what is done for it. Only for action_table.cpp.
#pragma once

#include <GLFW/glfw3.h>

#include "ui/app/action_row.h"

namespace triscope {

inline constexpr auto kEditActions = std::to_array<ActionInfo>({
    {Action::undo,
     Menu::edit,
     "undo",
     "Undo",
     "Takes back the last change of a parameter or of a density constraint.",
     {{{GLFW_KEY_Z, GLFW_MOD_CONTROL}}},
     when::undoes,
     [](Parts& p) { p.tuning.undo(); }},
    {Action::redo,
     Menu::edit,
     "redo",
     "Redo",
     "Makes the change that was taken back again.",
     {{{GLFW_KEY_Z, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT}, {GLFW_KEY_Y, GLFW_MOD_CONTROL}}},
     when::redoes,
     [](Parts& p) { p.tuning.redo(); }},
    {Action::place_density,
     Menu::edit,
     "place_density",
     "Place density constraints",
     "A click places one, a drag moves one; Alt+click places one at any time.",
     {{{GLFW_KEY_E, 0}}},
     when::placesDensity,
     [](Parts& p) { p.density.togglePlacing(); },
     [](const UiState& ui) { return ui.density.placing; }},
    {Action::delete_density,
     Menu::edit,
     "delete_density",
     "Delete density constraint",
     "Deletes the density constraint that is selected.",
     {{{GLFW_KEY_DELETE, 0}}},
     when::deletesDensity,
     [](Parts& p) { p.density.remove(); }},
});

}  // namespace triscope
