// Memory that is free in the program's heap.
#pragma once

namespace triscope {

/// Gives it back to the system, where the system can be given some: to be called where a large piece of work is over.
void giveBackFreeMemory();

}  // namespace triscope
