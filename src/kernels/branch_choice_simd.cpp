// Compiled once for each instruction set; the machine picks one at run time.
#define HWY_WANT_AVX3_DL 1  // hardware popcounts of whole vectors
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/branch_choice_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/branch_choice.hpp"
#include "kernels/color_classes_simd.hpp"

HWY_BEFORE_NAMESPACE();
namespace gmcr::kernels::HWY_NAMESPACE {

template <int kWords>
class Chooser {
 public:
  Chooser(BranchChoice& choice, RowLoops<kWords> loops)
      : choice_(choice), loops_(loops), classes_(choice, loops) {}

  void run() {
    loops_.copy(choice_.candidates, choice_.uncolored);
    color();
    classes_.start_repairs();
    append_rest();
  }

 private:
  const Word* row(Index v) const { return choice_.rows + v * loops_.num_words(); }

  /// Whether to go on, after that many word operations.
  bool spend(Index work) {
    unreported_work_ += work;
    if (unreported_work_ < kWorkPerReport) return true;
    ended_ = ended_ || !choice_.spend(choice_.budget, unreported_work_);
    unreported_work_ = 0;
    return !ended_;
  }

  void color() {
    Word* const uncolored = choice_.uncolored;
    Word* const free = choice_.free;
    Index first_word = 0;
    while (classes_.size() < choice_.max_classes && !ended_) {
      while (first_word < loops_.num_words() && uncolored[first_word] == 0) ++first_word;
      if (first_word == loops_.num_words()) return;
      classes_.open();
      loops_.copy(uncolored, free);
      const Index num_before = num_colored_;
      if (classes_.last() < choice_.num_seeds) take_seed(choice_.seeds[classes_.last()]);
      for (Index w = first_word; w < loops_.num_words(); ++w) {
        Word rest = free[w], taken = 0;
        while (rest != 0) {
          const Index v = 64 * w + __builtin_ctzll(rest);
          const Word lowest = rest & -rest;
          taken |= lowest;
          rest &= ~(row(v)[w] | lowest);
          loops_.subtract(row(v), free, free, w);
          if (choice_.repairs) classes_.add(classes_.last(), v);
          ++num_colored_;
        }
        uncolored[w] &= ~taken;
      }
      spend((num_colored_ - num_before) * loops_.num_words());
    }
  }

  void take_seed(Index v) {
    if (!has_bit(choice_.free, v)) return;
    loops_.subtract(row(v), choice_.free, choice_.free);
    clear_bit(choice_.free, v);
    clear_bit(choice_.uncolored, v);
    if (choice_.repairs) classes_.add(classes_.last(), v);
    ++num_colored_;
  }

  /// One independent set after the other of what has no class.
  void append_rest() {
    choice_.num_branches = 0;
    choice_.is_clique = num_colored_ == classes_.size();
    Index bound = choice_.max_classes;
    for (Index first_word = 0; first_word < loops_.num_words();) {
      if (choice_.uncolored[first_word] == 0) {
        ++first_word;
      } else {
        loops_.copy(choice_.uncolored, choice_.free);
        bound = append_class(first_word, bound);
      }
    }
  }

  Index append_class(Index first_word, Index bound) {
    Index class_size = 0, num_taken = 0;
    for (Index w = first_word; w < loops_.num_words(); ++w) {
      while (choice_.free[w] != 0) {
        const Index v = 64 * w + __builtin_ctzll(choice_.free[w]);
        clear_bit(choice_.free, v);
        clear_bit(choice_.uncolored, v);
        ++num_taken;
        if (!ended_ && repair(v)) continue;
        if (!ended_) loops_.subtract(row(v), choice_.free, choice_.free, w);
        if (class_size++ == 0 || ended_) ++bound;
        append(v, bound);
      }
    }
    choice_.is_clique = choice_.is_clique && num_taken == 1 && class_size == 1;
    return bound;
  }

  bool repair(Index v) {
    if (!classes_.may_repair()) return spend(loops_.num_words()), false;
    const Index work_before = classes_.work_left();
    const bool repaired = classes_.repair(v);
    spend(work_before - classes_.work_left());
    return repaired;
  }

  void append(Index v, Index bound) {
    choice_.branch_vertices[choice_.num_branches] = static_cast<std::int32_t>(v);
    choice_.branch_bounds[choice_.num_branches++] = static_cast<std::int32_t>(bound);
  }

  static constexpr Index kWorkPerReport = Index{1} << 16;

  BranchChoice& choice_;
  RowLoops<kWords> loops_;
  Classes<kWords> classes_;
  Index num_colored_ = 0;
  Index unreported_work_ = 0;
  bool ended_ = false;
};

void choose_branches(BranchChoice& choice) {
  switch (choice.num_words) {
    case 4:
      return Chooser<4>(choice, {}).run();
    case 8:
      return Chooser<8>(choice, {}).run();
    case 16:
      return Chooser<16>(choice, {}).run();
    default:
      return Chooser<0>(choice, {choice.num_words}).run();
  }
}

Index intersect(const Word* here, const Word* neighbors, Index num_words, Word* next) {
  if (num_words == 4) return RowLoops<4>{}.count_intersection(here, neighbors, next);
  return RowLoops<0>{num_words}.count_intersection(here, neighbors, next);
}

}  // namespace gmcr::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gmcr::kernels {

HWY_EXPORT(choose_branches);
HWY_EXPORT(intersect);

void choose_branches(BranchChoice& choice) { HWY_DYNAMIC_DISPATCH(choose_branches)(choice); }

Index intersect(const std::uint64_t* here, const std::uint64_t* neighbors, Index num_words,
                std::uint64_t* next) {
  return HWY_DYNAMIC_DISPATCH(intersect)(here, neighbors, num_words, next);
}

}  // namespace gmcr::kernels
#endif
