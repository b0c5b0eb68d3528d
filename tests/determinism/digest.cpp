// triscope_digest DOMAIN…: a line for every stage of every run, by each preset, with the digests of the state and of
// the events so far. Two builds of this program must print the same; the first line that differs names the stage to
// look at.
#include <fmt/format.h>

#include <memory>
#include <string_view>
#include <vector>

#include "core/domain/read.h"
#include "core/io/events_file.h"
#include "core/method/pipeline.h"
#include "core/words/preset.h"

namespace {

using namespace triscope;

/// FNV-1a, carried on over successive texts.
void mix(std::uint64_t& digest, std::string_view text) {
  for (const char c : text) digest = (digest ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
}

bool digest(const std::string& file, const Preset& preset) {
  Settings settings;
  applyPreset(settings, preset);
  Result<Domain> domain = readDomain(file);
  Result<MeshState> state =
      domain.ok() ? begin(std::make_shared<const Domain>(std::move(*domain)), settings) : domain.error();
  if (!state.ok()) {
    fmt::print(stderr, "{}\n", describe(state.error()));
    return false;
  }
  std::vector<Event> events;
  Journal journal{&events};
  std::uint64_t heard = 0xcbf29ce484222325u;
  std::uint64_t count = 0;
  while (state->stage != Stage::finished) {
    const std::string_view stage = infoOf(state->stage).key;
    const int round = state->round;
    advance(*state, Grain::stage, journal);
    for (const Event& event : events) mix(heard, eventLine(event, count++));
    events.clear();
    fmt::print("{} by {}: {} round {} decisions {} state {:016x} events {:016x}\n", state->domain->name, preset.key,
               stage, round, state->tick, hashOf(*state), heard);
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  bool good = argc > 1;
  for (int i = 1; i < argc; ++i)
    for (const Preset& preset : presets()) good = digest(argv[i], preset) && good;
  return good ? 0 : 1;
}
