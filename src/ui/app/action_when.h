// When actions can be done. Each answers with the reason why not, as a sentence for people; empty when it can be.
// Only for the table of actions and their owners: everyone else asks infoOf(action).whyNot().
#pragma once

#include <string>

#include "ui/model/view.h"

namespace triscope::when {

std::string always(const RunView& view);
std::string hasMesh(const RunView& view);  // to look at

// The run.
std::string goesOn(const RunView& view);
std::string goesBack(const RunView& view);
std::string playsOrPauses(const RunView& view);
std::string stepsInto(const RunView& view);
std::string slower(const RunView& view);
std::string faster(const RunView& view);

// Files.
std::string savesSession(const RunView& view);
std::string restores(const RunView& view);
std::string writes(const RunView& view);
std::string readsAgain(const RunView& view);

// Edits.
std::string undoes(const RunView& view);
std::string redoes(const RunView& view);
std::string placesDensity(const RunView& view);
std::string deletesDensity(const RunView& view);

// The picture.
std::string hasWorstAspect(const RunView& view);
std::string hasWorstArea(const RunView& view);
std::string hasWorstEdge(const RunView& view);
std::string larger(const RunView& view);
std::string smaller(const RunView& view);

// The debugger.
std::string holdsRun(const RunView& view);  // the run shown is that of the parameters
std::string continuesBack(const RunView& view);
std::string hasSelection(const RunView& view);
std::string hasMarkBefore(const RunView& view);
std::string hasMarkAfter(const RunView& view);
std::string differs(const RunView& view);

// Sweeps over ω and θ.
std::string sweeps(const RunView& view);
std::string savesSweep(const RunView& view);
std::string hasSweep(const RunView& view);
std::string takesCell(const RunView& view);

}  // namespace triscope::when
