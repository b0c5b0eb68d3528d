// Any bytes at all: the reader gives a domain or an error that explains itself, and a domain it gives is sound.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/domain/check.h"
#include "core/domain/outline.h"
#include "core/domain/read.h"

namespace {

using namespace triscope;

void require(bool sound) {
  if (!sound) std::abort();
}

bool finite(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }

void checkCurve(const Curve& curve) {
  require(pointAt(curve, 0.0) == curve.a && pointAt(curve, 1.0) == curve.b);
  for (const double t : {0.0, 0.3, 0.5, 0.99, 1.0}) {
    require(finite(pointAt(curve, t)));
    require(finite(derivativeAt(curve, t)));
    require(curvatureAt(curve, t) >= 0.0);
  }
  require(lengthBetween(curve, 0.0, 1.0) > 0.0);
}

void checkLoop(const Domain& domain, std::uint32_t index) {
  const Loop& loop = domain.loops[index];
  require(!loop.name.empty() && loop.curveCount > 0);
  require((loop.role == LoopRole::outer) == (index == 0));
  const Curve* curves = domain.curves.data() + loop.firstCurve;
  for (std::uint32_t i = 0; i + 1 < loop.curveCount; ++i) require(curves[i].b == curves[i + 1].a);
  if (loop.role != LoopRole::chain) require(curves[loop.curveCount - 1].b == curves[0].a);
  require(!outlineOf(domain, index).empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto domain = parseDomain({reinterpret_cast<const char*>(data), size}, "fuzz.json");
  if (!domain) {
    const Error& error = domain.error();
    require(error.code == ExitCode::bad_data && error.file == "fuzz.json");
    require(!error.message.empty() && !error.hint.empty() && !describe(error).empty());
    require(!error.at || finite(*error.at));
    return 0;
  }
  require(!domain->loops.empty() && !domain->bounds.empty());
  for (const Curve& curve : domain->curves) checkCurve(curve);
  for (std::uint32_t i = 0; i < domain->loops.size(); ++i) checkLoop(*domain, i);
  require(checkDomain(*domain).ok());  // oriented once, it stays so
  return 0;
}
