// Any bytes as a session file: an error that says what to do, or a session that is written and read back the same.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/session/session_file.h"

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace triscope;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const Result<SessionFile> session = parseSession(text, "fuzz.session");
  if (!session.ok()) {
    require(!session.error().message.empty());
    return 0;
  }
  const std::string written = sessionText(*session);
  const Result<SessionFile> again = parseSession(written, "fuzz.session");
  require(again.ok());
  require(sessionText(*again) == written);
  return 0;
}
