// What the window has done beside it: one piece of work at a time, whose outcome is told once.
#include "ui/model/background_job.h"

#include <gtest/gtest.h>

#include <chrono>

namespace triscope::background_job_test {
namespace {

std::optional<Status> outcomeOf(BackgroundJob& job) {
  for (;;) {
    if (std::optional<Status> outcome = job.finished()) return outcome;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(BackgroundJob, TellsItsOutcomeOnce) {
  BackgroundJob job;
  std::atomic<int> woken{0};
  int made = 0;
  for (int k = 1; k <= 20; ++k) {
    job.start(
        [&]() -> Status {
          ++made;
          return success();
        },
        [&] { ++woken; });
    EXPECT_TRUE(job.running());
    EXPECT_TRUE(outcomeOf(job)->ok());
    EXPECT_EQ(made, k) << "what the work has written is there for whoever asked for it";
    EXPECT_EQ(woken, k);
    EXPECT_FALSE(job.running());
    EXPECT_FALSE(job.finished().has_value());
  }
}

TEST(BackgroundJob, TellsWhereMemoryDidNotSuffice) {
  BackgroundJob job;
  job.start([]() -> Status { throw std::bad_alloc(); }, [] {});
  EXPECT_EQ(outcomeOf(job)->error().kind, ErrorKind::no_memory);
}

TEST(BackgroundJob, IsWaitedForWhereNobodyAsks) {
  int made = 0;
  {
    BackgroundJob job;
    job.start(
        [&]() -> Status {
          std::this_thread::sleep_for(std::chrono::milliseconds(20));
          ++made;
          return success();
        },
        [] {});
  }
  EXPECT_EQ(made, 1);
}

}  // namespace
}  // namespace triscope::background_job_test
