// Compiled once for each instruction set; the machine picks one at run time.
#define HWY_WANT_AVX3_DL 1  // hardware popcounts of whole vectors
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/bits/branch_choice_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/bits/branch_choice.hpp"
#include "kernels/bits/colour_classes_simd.hpp"

HWY_BEFORE_NAMESPACE();
namespace gmcr::kernels::HWY_NAMESPACE {

template <int kWords>
class Chooser {
 public:
  Chooser(const BranchInput& input, BranchScratch& scratch, RowLoops<kWords> loops)
      : input_(input),
        branches_(scratch.branches.data()),
        uncoloured_(scratch.uncoloured.data()),
        free_(scratch.free.data()),
        loops_(loops),
        classes_(input, scratch, loops) {}

  BranchChoice run() {
    loops_.copy(input_.candidates, uncoloured_);
    colour();
    classes_.start_repairs();
    append_rest();
    return {{branches_, static_cast<std::size_t>(num_branches_)}, is_clique_};
  }

 private:
  const Word* row(Index v) const { return input_.rows + v * loops_.num_words(); }

  /// Whether to go on, after that many word operations.
  bool spend(Index work) {
    unreported_work_ += work;
    if (unreported_work_ < kWorkPerReport) return true;
    ended_ = ended_ || !input_.spend(unreported_work_);
    unreported_work_ = 0;
    return !ended_;
  }

  void colour() {
    Word* const uncoloured = uncoloured_;
    Word* const free = free_;
    const auto num_seeds = static_cast<Index>(input_.seeds.size());
    Index first_word = 0;
    while (classes_.size() < input_.max_classes && !ended_) {
      while (first_word < loops_.num_words() && uncoloured[first_word] == 0) ++first_word;
      if (first_word == loops_.num_words()) return;
      classes_.open();
      loops_.copy(uncoloured, free);
      const Index num_before = num_coloured_;
      if (classes_.last() < num_seeds) take_seed(input_.seeds[classes_.last()]);
      for (Index w = first_word; w < loops_.num_words(); ++w) {
        Word rest = free[w], taken = 0;
        while (rest != 0) {
          const Index v = 64 * w + __builtin_ctzll(rest);
          const Word lowest = rest & -rest;
          taken |= lowest;
          rest &= ~(row(v)[w] | lowest);
          loops_.subtract(row(v), free, free, w);
          if (input_.repairs) classes_.add(classes_.last(), v);
          ++num_coloured_;
        }
        uncoloured[w] &= ~taken;
      }
      spend((num_coloured_ - num_before) * loops_.num_words());
    }
  }

  void take_seed(Index v) {
    if (!has_bit(free_, v)) return;
    loops_.subtract(row(v), free_, free_);
    clear_bit(free_, v);
    clear_bit(uncoloured_, v);
    if (input_.repairs) classes_.add(classes_.last(), v);
    ++num_coloured_;
  }

  /// One independent set after the other of what has no class.
  void append_rest() {
    is_clique_ = num_coloured_ == classes_.size();
    Index bound = input_.max_classes;
    for (Index first_word = 0; first_word < loops_.num_words();) {
      if (uncoloured_[first_word] == 0) {
        ++first_word;
      } else {
        loops_.copy(uncoloured_, free_);
        bound = append_class(first_word, bound);
      }
    }
  }

  Index append_class(Index first_word, Index bound) {
    Index class_size = 0, num_taken = 0;
    for (Index w = first_word; w < loops_.num_words(); ++w) {
      while (free_[w] != 0) {
        const Index v = 64 * w + __builtin_ctzll(free_[w]);
        clear_bit(free_, v);
        clear_bit(uncoloured_, v);
        ++num_taken;
        if (!ended_ && repair(v)) continue;
        if (!ended_) loops_.subtract(row(v), free_, free_, w);
        if (class_size++ == 0 || ended_) ++bound;
        append(v, bound);
      }
    }
    is_clique_ = is_clique_ && num_taken == 1 && class_size == 1;
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
    branches_[num_branches_++] = {static_cast<std::int32_t>(v), static_cast<std::int32_t>(bound)};
  }

  static constexpr Index kWorkPerReport = Index{1} << 16;

  const BranchInput& input_;
  Branch* branches_;
  Word *uncoloured_, *free_;
  RowLoops<kWords> loops_;
  Classes<kWords> classes_;
  Index num_branches_ = 0;
  bool is_clique_ = false;
  Index num_coloured_ = 0;
  Index unreported_work_ = 0;
  bool ended_ = false;
};

BranchChoice choose_branches(const BranchInput& input, BranchScratch& scratch) {
  switch (input.num_words) {
    case 4:
      return Chooser<4>(input, scratch, {}).run();
    case 8:
      return Chooser<8>(input, scratch, {}).run();
    case 16:
      return Chooser<16>(input, scratch, {}).run();
    default:
      return Chooser<0>(input, scratch, {input.num_words}).run();
  }
}

Index intersect(const Word* here, const Word* neighbours, Index num_words, Word* next) {
  if (num_words == 4) return RowLoops<4>{}.count_intersection(here, neighbours, next);
  return RowLoops<0>{num_words}.count_intersection(here, neighbours, next);
}

}  // namespace gmcr::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gmcr::kernels {

HWY_EXPORT(choose_branches);
HWY_EXPORT(intersect);

BranchChoice choose_branches(const BranchInput& input, BranchScratch& scratch) {
  return HWY_DYNAMIC_DISPATCH(choose_branches)(input, scratch);
}

Index intersect(const std::uint64_t* here, const std::uint64_t* neighbours, Index num_words,
                std::uint64_t* next) {
  return HWY_DYNAMIC_DISPATCH(intersect)(here, neighbours, num_words, next);
}

}  // namespace gmcr::kernels
#endif
