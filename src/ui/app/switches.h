// What is switched on and off, or stepped through, without more ado.
#pragma once

#include "ui/app/desk.h"

namespace triscope {

inline void flip(bool& value) { value = !value; }

/// Decisions per second when playing; a run that plays goes on with it.
void setSpeed(Desk& desk, double decisionsPerSecond);
/// In steps of a quarter, from 75 % to 300 %.
void setScale(UiState& ui, double scale);
void toggleQuadtree(UiState& ui);
/// Shows a panel above the timeline, or hides it.
void toggleBottom(UiState& ui, Panel panel);
void nextFill(UiState& ui);
void nextTheme(UiState& ui);

}  // namespace triscope
