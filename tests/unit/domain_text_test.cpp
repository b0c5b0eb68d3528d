// A domain file with another density: read back it asks for just that, and the rest of it is as it was written.
#include "core/io/domain_text.h"

#include <gtest/gtest.h>

#include "core/domain/read.h"

namespace triscope::domain_text_test {
namespace {

using Where = DensityRequest::Where;

constexpr std::string_view kBefore = R"({ "outer" : [[0,0], [4, 0],[4,4]] , "note, \"density\"": {"density": [1]},)";

std::vector<DensityRequest> requests() {
  DensityRequest point;
  point.at = {1.0 / 3.0, 0.1};
  point.length = 0.25;
  point.name = "a \"name\"";
  point.description = "why\nit is";
  DensityRequest box;
  box.where = Where::box;
  box.at = {1, 1};
  box.to = {2, 1.5};
  box.rank = 4;
  DensityRequest loop;
  loop.where = Where::loop;
  loop.loop = "outer";
  loop.length = 1.0;
  return {point, box, loop};
}

Domain parsed(const std::string& text) {
  Result<Domain> domain = parseDomain(text, "a.json");
  if (!domain) ADD_FAILURE() << describe(domain.error()) << " in " << text;
  return domain ? *domain : Domain{};
}

TEST(DomainText, ReplacesTheList) {
  const std::string head = std::string(kBefore) + " \"dens\\u0069ty\":";
  for (const std::string old : {"[]", "[{\"at\": [1, 0.5], \"rank\": 2, \"name\": \"]}\\\\\"}]"}) {
    const std::string text = withDensity(head + old + " , \"name\": \"x\"}\n", requests());
    EXPECT_TRUE(text.starts_with(head + "[")) << text;
    EXPECT_TRUE(text.ends_with(" , \"name\": \"x\"}\n")) << text;
    EXPECT_EQ(parsed(text).density, requests());
    EXPECT_TRUE(parsed(withDensity(text, {})).density.empty());
  }
}

TEST(DomainText, AddsAList) {
  const std::string bare = R"({"outer": [[0, 0], [4, 0], [4, 4]], "scale": 1e3 })";
  EXPECT_EQ(withDensity(bare, {}), bare);
  const std::string text = withDensity(bare, requests());
  EXPECT_TRUE(text.starts_with(bare.substr(0, bare.size() - 2))) << text;
  EXPECT_EQ(parsed(text).density, requests());
}

TEST(DomainText, ADomainKeepsItsText) {
  const Domain before = parsed(R"({"outer": [[0, 0], [4, 0], [4, 4]]})");
  const std::shared_ptr<const Domain> after = withDensity(before, requests());
  EXPECT_EQ(after->density, requests());
  EXPECT_EQ(parsed(after->text).density, requests());
  EXPECT_EQ(parsed(after->text).text, after->text);
  EXPECT_EQ(after->curves.size(), before.curves.size());
}

}  // namespace
}  // namespace triscope::domain_text_test
