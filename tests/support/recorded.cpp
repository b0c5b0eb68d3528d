#include "support/recorded.h"

#include <map>

#include "core/method/pipeline.h"
#include "support/runs.h"

namespace triscope::support {

Recorded record(const DomainPtr& domain, std::size_t budget) {
  Recorded run{start(domain), {}, History(budget), {}};
  run.history.restart(run.end);
  Journal journal{&run.events};
  for (bool more = true; more;) {
    more = advance(run.end, Grain::decision, journal);
    run.tickAt.resize(run.events.size(), run.end.tick);
    run.history.offer(run.end, run.events.size());
  }
  return run;
}

const Recorded& runOf(const std::string& sample) {
  static std::map<std::string, Recorded> runs;
  const auto found = runs.find(sample);
  if (found != runs.end()) return found->second;
  return runs.emplace(sample, record(domainAt(samples() / (sample + ".json")), 1u << 22)).first->second;
}

}  // namespace triscope::support
