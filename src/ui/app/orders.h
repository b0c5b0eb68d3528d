// What is done for what panels, keys, menus and owners order.
#pragma once

#include "ui/app/parts.h"

namespace triscope {

void carryOut(Parts& parts, const Order& order);
/// Carries out all of them, and those that come of them.
void carryOut(Parts& parts, const Orders& orders);
/// Where the action cannot be done, the message says why.
void perform(Parts& parts, Action action);
/// A command by hand: what was on its way to an insertion is not waited for.
void apply(Parts& parts, const Command& command);
/// Esc: gives up what is innermost of what is open, under way or chosen.
void cancelInnermost(Parts& parts);

}  // namespace triscope
