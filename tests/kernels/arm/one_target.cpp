// Highway's choice of an instruction set in a build that has only one of them and no library of
// Highway.
#include <hwy/highway.h>

namespace hwy {

int64_t SupportedTargets() { return HWY_STATIC_TARGET; }

void SetSupportedTargetsForTest(int64_t) {}

ChosenTarget& GetChosenTarget() {
  static ChosenTarget chosen;
  return chosen;
}

}  // namespace hwy
