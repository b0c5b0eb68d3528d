// Any bytes at all: the reader gives a domain or an error that explains itself, and a domain it gives is sound.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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

/// Where the numbers of a text begin and end.
std::vector<std::pair<std::size_t, std::size_t>> numbersIn(std::string_view text) {
  constexpr std::string_view kDigits = "+-.0123456789eE";
  std::vector<std::pair<std::size_t, std::size_t>> numbers;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '-' && (text[i] < '0' || text[i] > '9')) continue;
    const std::size_t end = std::min(text.find_first_not_of(kDigits, i), text.size());
    numbers.emplace_back(i, end);
    i = end;
  }
  return numbers;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

/// Bytes flipped at random seldom make another number, and numbers are what geometry trips over: half of the
/// mutations swap one number for another that is in the text, or for one of the edge of what is allowed.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  constexpr std::string_view kEdges[] = {"0",     "-0.0",  "1",     "-1",  "0.5",  "3",    "1e-40", "-1e-40", "1e30",
                                         "-1e30", "1e-17", "1e-20", "1e8", "1e16", "1e15", "64",    "179.99", "4e7"};
  std::minstd_rand random(seed);
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto numbers = numbersIn(text);
  if (numbers.empty() || random() % 2 == 0) return LLVMFuzzerMutate(data, size, most);
  const auto [begin, end] = numbers[random() % numbers.size()];
  const auto [otherBegin, otherEnd] = numbers[random() % numbers.size()];
  const std::string other = random() % 2 == 0 ? text.substr(otherBegin, otherEnd - otherBegin)
                                              : std::string(kEdges[random() % std::size(kEdges)]);
  const std::string mutated = text.substr(0, begin) + other + text.substr(end);
  if (mutated.size() > most) return LLVMFuzzerMutate(data, size, most);
  std::copy(mutated.begin(), mutated.end(), data);
  return mutated.size();
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto domain = parseDomain({reinterpret_cast<const char*>(data), size}, "fuzz.json");
  if (!domain) {
    const Error& error = domain.error();
    require(error.kind == ErrorKind::bad_data && error.file == "fuzz.json");
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
