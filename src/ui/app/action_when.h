// When actions can be done. Each answers with the reason why not, as a sentence for people; empty when it can be.
// Only for the table of what is done for each action, app_actions.cpp: everyone else asks whyNot().
#pragma once

#include <string>

#include "ui/model/view.h"

namespace triscope::when {

std::string always(const View& view);
std::string hasMesh(const View& view);  // to look at

// The run.
std::string goesOn(const View& view);
std::string goesBack(const View& view);
std::string playsOrPauses(const View& view);
std::string stepsInto(const View& view);
std::string slower(const View& view);
std::string faster(const View& view);

// Files.
std::string savesSession(const View& view);
std::string restores(const View& view);
std::string writes(const View& view);
std::string readsAgain(const View& view);

// Edits.
std::string undoes(const View& view);
std::string redoes(const View& view);
std::string placesDensity(const View& view);
std::string deletesDensity(const View& view);

// The picture.
std::string hasWorstAspect(const View& view);
std::string hasWorstArea(const View& view);
std::string hasWorstEdge(const View& view);
std::string larger(const View& view);
std::string smaller(const View& view);

// The debugger.
std::string holdsRun(const View& view);  // the run shown is that of the parameters
std::string continuesBack(const View& view);
std::string hasSelection(const View& view);
std::string hasMarkBefore(const View& view);
std::string hasMarkAfter(const View& view);
std::string differs(const View& view);

// Sweeps over ω and θ.
std::string sweeps(const View& view);
std::string savesSweep(const View& view);
std::string hasSweep(const View& view);
std::string takesCell(const View& view);

}  // namespace triscope::when
