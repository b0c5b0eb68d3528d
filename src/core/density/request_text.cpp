#include "core/density/request_text.h"

#include <fmt/format.h>

#include "core/base/number.h"
#include "core/base/shown_text.h"
#include "core/density/sources.h"

namespace triscope {

std::string requestName(const Domain& domain, std::size_t index) {
  const std::string& name = domain.density[index].name;
  return name.empty() ? fmt::format("density entry {}", index + 1) : fmt::format("density entry '{}'", shown(name));
}

std::vector<std::string> requestsCut(const Domain& domain, double minEdge) {
  std::vector<std::string> notes;
  for (std::size_t k = 0; k < domain.density.size(); ++k) {
    const double length = lengthWanted(domain.density[k], minEdge);
    if (length < minEdge)
      notes.push_back(fmt::format("{} asks for edges of length {}, but gets none below min_edge_length, which is {}",
                                  requestName(domain, k), compact(length), compact(minEdge)));
  }
  return notes;
}

}  // namespace triscope
