// main() of all test programs: lets them find the source tree and the tool however they are
// started.
#include <gtest/gtest.h>

#include <cstdlib>

int main(int argc, char** argv) {
  constexpr int kKeepWhatIsSet = 0;
  setenv("GMCR_SOURCE_DIR", GMCR_TEST_SOURCE_DIR, kKeepWhatIsSet);
  setenv("GMCR_BIN", GMCR_TEST_BIN, kKeepWhatIsSet);
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
