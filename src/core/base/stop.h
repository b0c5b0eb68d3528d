// How the program ends when it is told to: at once, wherever it is, and without a temporary file left behind.
//
// Nothing has to look at a flag: the handler of the signal takes the temporary files away and leaves. Only what must
// not be cut in two, such as the renames of a set of files, holds it off for a moment.
#pragma once

#include <string>

namespace triscope {

/// From now on Ctrl+C, TERM, the end of the terminal and a pipe that nobody reads end the program with 128 + the
/// number of the signal. It says so on stderr, but for the pipe.
void endOnSignals();

/// While one lives, a signal waits; it is obeyed when the last one is gone.
class Undisturbed {
 public:
  Undisturbed();
  ~Undisturbed();
  Undisturbed(const Undisturbed&) = delete;
  Undisturbed& operator=(const Undisturbed&) = delete;
};

/// A file to be removed should the program be told to end. Both under an Undisturbed that also makes or removes it.
/// A table that is full, or a name that is too long, is no error: such a file is cleared by the next program.
void rememberTemporary(const std::string& path);
void forgetTemporary(const std::string& path);

/// What the last words are about. The highest of what happened counts.
enum class Written : int { nothing, direct, files };
void noteWritten(Written what);

/// The progress line is on the terminal and is to be wiped before the last words.
void noteProgressShown(bool shown);

}  // namespace triscope
