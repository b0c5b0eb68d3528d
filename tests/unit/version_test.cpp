// Files say which version made them; a reader is told where it was another.
#include "core/base/version.h"

#include <gtest/gtest.h>

namespace triscope::version_test {
namespace {

TEST(Version, NothingIsSaidOfWhatThisVersionSaved) { EXPECT_EQ(versionNote(thisVersion()), ""); }

TEST(Version, AnotherMethodMakesOtherMeshes) {
  MadeBy other = thisVersion();
  other.method += 1;
  EXPECT_NE(versionNote(other).find("meshes and decisions may differ"), std::string::npos) << versionNote(other);
  EXPECT_NE(versionNote({"0.0.1", 1}).find("saved by triscope 0.0.1 with version 1 of the method; this is "),
            std::string::npos);
}

TEST(Version, AnotherProgramWithTheSameMethodDoesNot) {
  const std::string note = versionNote({"0.0.1", kMethodVersion});
  EXPECT_NE(note.find("saved by triscope 0.0.1; this is "), std::string::npos) << note;
  EXPECT_EQ(note.find("differ"), std::string::npos) << note;
}

TEST(Version, WhatAFileSaysIsShownWithoutControls) {
  for (const int method : {1, kMethodVersion}) {
    const std::string note = versionNote({"\x1b[31m9.9", method});
    EXPECT_EQ(note.find('\x1b'), std::string::npos) << note;
  }
}

TEST(Version, WhatDoesNotSayMayBeAnything) {
  for (const MadeBy& old : {MadeBy{}, MadeBy{"0.1.0", 0}, MadeBy{"", 1}})
    EXPECT_NE(versionNote(old).find("did not say"), std::string::npos);
}

}  // namespace
}  // namespace triscope::version_test
