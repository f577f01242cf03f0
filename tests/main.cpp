// main() of all test programs: lets them find the source tree and the tool however they are
// started, and gives TBB more threads than small machines have cores, so that tests of threads have
// them everywhere.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstdlib>

int main(int argc, char** argv) {
  constexpr std::size_t kNumThreads = 8;
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, kNumThreads);
  constexpr int kKeepWhatIsSet = 0;
  setenv("GMCR_SOURCE_DIR", GMCR_TEST_SOURCE_DIR, kKeepWhatIsSet);
  setenv("GMCR_BIN", GMCR_TEST_BIN, kKeepWhatIsSet);
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
