// What the rows of the table of actions are made from. Only for its parts, actions_*.h.
#pragma once

#include <algorithm>

#include "ui/app/action_when.h"
#include "ui/app/exporting.h"
#include "ui/app/framing.h"
#include "ui/app/orders.h"
#include "ui/app/picture.h"
#include "ui/app/switches.h"
