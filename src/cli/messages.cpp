#include "cli/messages.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

namespace triscope {

void sayText(std::string_view text) {
  [[maybe_unused]] const std::size_t said = std::fwrite(text.data(), 1, text.size(), stderr);
}

void answerText(std::string_view text) {
  [[maybe_unused]] const std::size_t written = std::fwrite(text.data(), 1, text.size(), stdout);
}

bool endOfAnswers() { return std::fflush(stdout) == 0 && std::ferror(stdout) == 0; }

void holdStandardStreams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) >= 0) continue;
    // The lowest number that is free is this one; opened the wrong way round, so that using it fails as before.
    [[maybe_unused]] const int held = ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

}  // namespace triscope
