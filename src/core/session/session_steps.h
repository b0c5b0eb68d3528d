// What the commands of a session and its slices are made of. For session_work.cpp and session_orders.cpp alone.
#pragma once

#include <new>

#include "core/session/session_work.h"

namespace triscope {

/// Sets out for a goal, and says so.
void setOut(SessionWork& work, const Goal& goal, Activity activity);
/// Stops where the run is, which is then the run to show.
void halt(SessionWork& work);
/// Stops; a run that is being made anew is given up for the one from before.
void cancel(SessionWork& work);
/// Another run takes the place of the one at hand, which is kept to be returned to until there is one to show.
void replaceRun(SessionWork& work, Run run);
/// To be called when what comes after the state is another run: its events will be.
void dropEventsAfter(SessionWork& work);

void tellState(SessionWork& work);
void tellProgress(SessionWork& work);
/// How far a search is: at `probe`, and that part of the way when it is known. Of a run that has no state yet `probe`
/// has the domain and the settings alone.
void tellSearch(SessionWork& work, const MeshState& probe, std::optional<double> fraction);
void fail(SessionWork& work, Error error);
/// Finds some more measures along the run, and tells them now and then.
void traceOn(SessionWork& work);

/// The run goes back to what it was before it was being made anew, or else to its beginning: memory has run out.
void giveUp(SessionWork& work);
template <class Work>
void survive(SessionWork& work, const Work& does) {
  try {
    does();
  } catch (const std::bad_alloc&) {
    giveUp(work);
  }
}

}  // namespace triscope
